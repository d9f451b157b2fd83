#include "app/commands.h"
#include "base/build_paths.h"
#include "base/process/child.h"

#include <fmt/format.h>
#include <memory>
#include <string>
#include <vector>

namespace muelle::app {

namespace {

struct TestOptions {
  std::string filter;
  bool listOnly = false;
};

/// The tests of the framework and of the grader; grading a submission (label `grade`) is another command.
int test(const TestOptions& options) {
  std::vector<std::string> command{"ctest",      "--test-dir", build_paths::binary,   "--label-exclude", "^grade$",
                                   "--parallel", "2",          "--output-on-failure", "--no-tests=error"};
  if (!options.filter.empty()) command.insert(command.end(), {"--tests-regex", options.filter});
  if (options.listOnly) command.push_back("--show-only");
  const bool isDone = runInForeground(command) == 0;
  // CTest does not look whether its words get anywhere; ours end the command when they do not.
  if (!options.listOnly) fmt::print("{}\n", isDone ? "every test passes" : "something fails, see above");
  if (options.listOnly) fmt::print("next: ./muelle test NAME\n");
  return isDone ? 0 : 1;
}

}  // namespace

void addTest(CommandLine& program) {
  const auto options = std::make_shared<TestOptions>();
  CommandLine& command = program.command("test", "Run the tests of the framework, of the course and of the grader");
  command.option("REGEX", options->filter, "Only the tests whose name matches");
  command.flag("--list", options->listOnly, "Name the tests, run none");
  command.footer("Example: ./muelle test manifest");
  command.action([options] { return test(*options); });
}

}  // namespace muelle::app
