#include "app/instructor/run_ctest.h"

#include "base/build_paths.h"
#include "base/process/child.h"

#include <algorithm>
#include <thread>

namespace muelle::app {

int runCtest(const std::vector<std::string>& selection) {
  const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
  const unsigned tests = 2 * cores + 1;  // a test of limits waits more than it works
  std::vector<std::string> command{"ctest",           "--test-dir",          build_paths::binary,
                                   "--parallel",      std::to_string(tests), "--output-on-failure",
                                   "--no-tests=error"};
  command.insert(command.end(), selection.begin(), selection.end());
  return runInForeground(command) == 0 ? 0 : 1;
}

}  // namespace muelle::app
