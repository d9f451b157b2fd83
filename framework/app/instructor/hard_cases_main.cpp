/// \file
/// The program behind `muelle hard-cases`: every method on every hard case.

#include "base/command_line.h"
#include "base/errors.h"
#include "base/file.h"
#include "base/progress_bar.h"
#include "figures/write.h"
#include "lab/hard_cases/matrix.h"

#include <fmt/format.h>
#include <unistd.h>
#include <cstdio>
#include <filesystem>

namespace {

using namespace muelle::hard_cases;

struct Command {
  MatrixOptions options;
  std::string csv;
  std::string out;
};

int runAll(const Command& command) {
  Matrix matrix = planMatrix(command.options);
  {
    muelle::ProgressBar bar("every method on every hard case");
    runMatrix(matrix, command.options, [&bar](double fraction) { bar.update(fraction); });
  }
  fmt::print("{}\n{}", matrixText(matrix, isatty(STDOUT_FILENO) == 1), summaryText(matrix));
  if (!command.csv.empty()) muelle::writeFile(command.csv, matrixCsv(matrix));
  if (!command.out.empty()) {
    const std::filesystem::path folder = command.out;
    std::filesystem::create_directories(folder);
    muelle::writeFile(folder / "hard_cases.md", matrixPage(matrix));
    muelle::writeFigures({matrixFigure(matrix)}, folder, {muelle::Format::Svg, muelle::Format::Png});
    if (command.csv.empty()) muelle::writeFile(folder / "hard_cases.csv", matrixCsv(matrix));
  }
  return matrix.count(Outcome::FailedUnexpectedly) == 0 ? 0 : 1;
}

int run(int argc, char** argv) {
  Command command;
  muelle::CommandLine program("./muelle hard-cases",
                              "Every method of the engine on every hard case: predicted first, then run.");
  program.option("--case", command.options.cases, "Only these cases: H01 ... H24 [all]");
  program.option("--method", command.options.methods, "Only these methods, by their ids [all]");
  program.flag("--long", command.options.longRuns, "H01 over its million periods (minutes), and larger budgets");
  program.option("--csv", command.csv, "Also write every cell to this file");
  program.option("--out", command.out, "Write the page, the figure and the CSV file to this folder");
  program.footer(
      "1e-09 passed, ~1e-01 failed as predicted, n/a the system lacks what the method needs, ! failed unexpectedly.\n"
      "Exit code: 1 when a cell failed unexpectedly, else 0.\n"
      "Examples: ./muelle hard-cases --case H17 H18\n"
      "          ./muelle hard-cases --method velocity_verlet --csv cells.csv\n"
      "          ./muelle hard-cases --case H01 --long");
  program.action([&command] { return runAll(command); });
  return program.run(argc, argv);
}

}  // namespace

int main(int argc, char** argv) {
  return muelle::withErrorsOnOneLine([=] { return run(argc, argv); });
}
