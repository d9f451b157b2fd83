/// \file
/// The program behind `muelle hard-cases`: every method on every hard case.

#include "base/command_line.h"
#include "base/errors.h"
#include "base/file.h"
#include "base/progress_bar.h"
#include "figures/write.h"
#include "lab/hard_cases/million_periods.h"
#include "lab/hard_cases/report.h"

#include <fmt/format.h>
#include <unistd.h>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <stdexcept>

namespace {

using namespace muelle::hard_cases;

struct Command {
  MatrixOptions options;
  std::string csv;
  std::string out;
  std::string full;  ///< "H01": the case to be run over its full length
};

std::string today() {
  const std::chrono::year_month_day day{std::chrono::floor<std::chrono::days>(std::chrono::system_clock::now())};
  return fmt::format("{:04}-{:02}-{:02}", static_cast<int>(day.year()), static_cast<unsigned>(day.month()),
                     static_cast<unsigned>(day.day()));
}

/// H01 through its million periods, which takes minutes.
int runInFull(const Command& command) {
  if (command.full != "H01") {
    throw std::invalid_argument(fmt::format("--full {}: only H01 has a longer run; use --full H01", command.full));
  }
  H01InFull run;
  {
    muelle::ProgressBar bar("a million periods");
    run = runH01InFull(today(), [&bar](double fraction) { bar.update(fraction); });
  }
  fmt::print("{}", h01Table(run));
  if (!command.out.empty()) {
    const std::filesystem::path folder = command.out;
    std::filesystem::create_directories(folder);
    muelle::writeFile(folder / "h01_in_full.json", toJson(run));
    muelle::writeFigures({h01Figure(run)}, folder, {muelle::Format::Svg, muelle::Format::Png});
  }
  return std::ranges::all_of(run.rows, [](const MillionPeriods& row) { return row.verdict.empty(); }) ? 0 : 1;
}

int runAll(const Command& command) {
  if (!command.full.empty()) return runInFull(command);
  Matrix matrix = planMatrix(command.options);
  {
    muelle::ProgressBar bar("every method on every hard case");
    runMatrix(matrix, [&bar](double fraction) { bar.update(fraction); });
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
  return matrix.count(Outcome::FailedUnexpectedly) == 0 && unexplained(matrix).empty() ? 0 : 1;
}

int run(int argc, char** argv) {
  Command command;
  muelle::CommandLine program("./muelle hard-cases",
                              "Every method of the engine on every hard case: predicted first, then run.");
  program.option("--case", command.options.cases, "Only these cases: H01 ... H24 [all]");
  program.option("--method", command.options.methods, "Only these methods, by their ids [all]");
  program.option("--full", command.full, "H01: over its million periods (minutes), instead of the table");
  program.option("--csv", command.csv, "Also write every cell to this file");
  program.option("--out", command.out, "Write the page, the figure and the CSV file to this folder");
  program.footer(
      "1e-09 passed, ~1e-01 failed as predicted, n/a the system lacks what the method needs, ! failed unexpectedly.\n"
      "Exit code: 1 when a cell failed unexpectedly, or is better than predicted for no known reason; else 0.\n"
      "Examples: ./muelle hard-cases --case H17 H18\n"
      "          ./muelle hard-cases --method velocity_verlet --csv cells.csv\n"
      "          ./muelle hard-cases --full H01 --out out/hard_cases");
  program.action([&command] { return runAll(command); });
  return program.run(argc, argv);
}

}  // namespace

int main(int argc, char** argv) {
  return muelle::withErrorsOnOneLine([=] { return run(argc, argv); });
}
