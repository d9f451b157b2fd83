#include "app/commands.h"
#include "base/terminal.h"

#include <fmt/format.h>

namespace muelle::app {

void printNextSteps() {
  const auto step = [](const char* command, const char* what) {
    fmt::print("  {} {}\n", bold(fmt::format("{:<36}", command)), what);
  };
  fmt::print("Muelle: a course on mass-spring simulation that runs. What next?\n\n");
  step("./muelle check", "the first exercise that is not right yet, and what to mend");
  step("./muelle check spring_1d", "one exercise");
  step("./muelle list", "the exercises, in course order");
#if MUELLE_HAS_GRADER
  step("./muelle grade FOLDER", "grade a submission (./muelle grade solutions: the reference)");
  step("./muelle test-the-tests", "does every wrong submission lose what it must?");
  step("./muelle test", "the tests of the framework");
  step("./muelle docs", "write the documentation");
#endif
#if MUELLE_HAS_ENGINE
  step("./muelle run elastic_pendulum --plot", "simulate a scene: error, energy, cost, curves");
  step("./muelle rest hanging_chain --plot", "where a scene stands still: stable or not, tensions");
  step("./muelle figures", "draw the figures of the lecture");
  step("./muelle hard-cases", "every method on every hard case");
  step("./muelle bench --quick", "speed against error, beside other libraries");
#endif
  fmt::print("\nEvery command explains itself: ./muelle check --help\n");
}

}  // namespace muelle::app
