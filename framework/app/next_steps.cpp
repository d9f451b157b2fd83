#include "app/commands.h"
#include "base/terminal.h"

#include <fmt/format.h>

namespace muelle::app {

void printStep(const char* command, const char* what) {
  fmt::print("  {} {}\n", bold(fmt::format("{:<36}", command)), what);
}

void printNextSteps() {
  fmt::print("Muelle: a course on mass-spring simulation that runs. What next?\n\n");
  printStep("./muelle check", "the first exercise that is not right yet, and what to mend");
  printStep("./muelle check spring_1d", "one exercise");
  printStep("./muelle list", "the exercises, in course order");
#if MUELLE_HAS_INSTRUCTOR
  printInstructorSteps();
#endif
  fmt::print("\nEvery command explains itself: ./muelle check --help\n");
}

}  // namespace muelle::app
