#include "app/instructor/commands.h"
#include "app/instructor/run_ctest.h"

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
  std::vector<std::string> selection{"--label-exclude", "^grade$"};
  if (!options.filter.empty()) selection.insert(selection.end(), {"--tests-regex", options.filter});
  if (options.listOnly) selection.emplace_back("--show-only");
  const int status = runCtest(selection);
  // CTest does not look whether its words get anywhere; ours end the command when they do not.
  if (!options.listOnly) fmt::print("{}\n", status == 0 ? "every test passes" : "something fails, see above");
  if (options.listOnly) fmt::print("next: ./muelle test NAME\n");
  return status;
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
