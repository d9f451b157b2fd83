/// \file
/// The program behind `muelle hard-cases`: every method on every hard case.

#include "base/file.h"
#include "base/progress_bar.h"
#include "base/text/printable.h"
#include "figures/write.h"
#include "matrix/matrix.h"

#include <fmt/format.h>
#include <unistd.h>
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <stdexcept>

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
  CLI::App app("Every method of the engine on every hard case: predicted first, then run.", "muelle hard-cases");
  app.add_option("--case", command.options.cases, "Only these cases: H01 ... H24 [all]");
  app.add_option("--method", command.options.methods, "Only these methods, by their ids [all]");
  app.add_flag("--long", command.options.longRuns, "H01 over its million periods (minutes), and larger budgets");
  app.add_option("--csv", command.csv, "Also write every cell to this file");
  app.add_option("--out", command.out, "Write the page, the figure and the CSV file to this folder");
  app.footer(
      "1e-09 passed, ~1e-01 failed as predicted, n/a the system lacks what the method needs, ! failed unexpectedly.\n"
      "Exit code: 1 when a cell failed unexpectedly, else 0.\n"
      "Examples: ./muelle hard-cases --case H17 H18\n"
      "          ./muelle hard-cases --method velocity_verlet --csv cells.csv\n"
      "          ./muelle hard-cases --case H01 --long");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    throw std::invalid_argument(fmt::format("{} (see ./muelle hard-cases --help)", error.what()));
  }
  return runAll(command);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    fmt::print(stderr, "muelle: {}\n", muelle::printableLine(error.what()));
    return 2;
  }
}
