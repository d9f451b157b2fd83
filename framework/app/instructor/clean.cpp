#include "grader/run/clean.h"
#include "app/instructor/commands.h"

#include <fmt/format.h>

namespace muelle::app {

namespace {

int clean() {
  constexpr double mebibyte = 1024.0 * 1024.0;
  const auto bytes = static_cast<double>(grader::clean(grader::Workplace::ofThisBuild()));
  fmt::print("removed {:.1f} MiB of compiled hand-ins and verdicts; the seed is kept\n", bytes / mebibyte);
  return 0;
}

}  // namespace

void addClean(CommandLine& program) {
  CommandLine& command = program.command("clean", "Forget what has been graded, but not the seed");
  command.footer(
      "The next grading compiles and tests everything again, with the same inputs.\nExample: ./muelle clean");
  command.action([] { return clean(); });
}

}  // namespace muelle::app
