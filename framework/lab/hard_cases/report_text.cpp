#include "lab/hard_cases/cell_text.h"
#include "lab/hard_cases/report.h"

#include <fmt/format.h>

namespace muelle::hard_cases {

namespace {

const char* colourOf(Outcome outcome) {
  switch (outcome) {
    case Outcome::Passed:
      return "\x1b[32m";
    case Outcome::FailedAsPredicted:
      return "\x1b[33m";
    case Outcome::NotApplicable:
      return "\x1b[90m";
    case Outcome::FailedUnexpectedly:
      return "\x1b[31;1m";
  }
  return "";
}

}  // namespace

std::string matrixText(const Matrix& matrix, bool colours) {
  constexpr int first = 20, width = 9;
  std::string text = fmt::format("{:<{}}{:>8}", "case", first, "bar");
  for (const std::string& method : matrix.methods) text += fmt::format("{:>{}}", shortName(method), width);
  text += "\n";
  for (std::size_t v = 0; v < matrix.variants.size(); ++v) {
    text += fmt::format("{:<{}}{:>8.0e}", matrix.variants[v].label(), first, matrix.variants[v].bar);
    for (std::size_t m = 0; m < matrix.methods.size(); ++m) {
      const Cell& cell = matrix.at(m, v);
      const std::string padded = fmt::format("{:>{}}", cellText(cell), width);
      text += colours ? colourOf(cell.outcome) + padded + "\x1b[0m" : padded;
    }
    text += "\n";
  }
  return text;
}

std::string summaryText(const Matrix& matrix) {
  std::string text;
  double seconds = 0.0;
  for (const Cell* cell : unexplained(matrix)) {
    text += fmt::format("better than predicted: {} on {}, {}: error {:.3g}, predicted {:.3g}; {}\n", cell->method,
                        matrix.variants[cell->variant].label(), cell->setting, cell->error, cell->prediction.error,
                        cell->prediction.text);
  }
  for (const Cell& cell : matrix.cells) {
    seconds += cell.seconds;
    if (cell.outcome != Outcome::FailedUnexpectedly) continue;
    text += fmt::format("failed unexpectedly: {} on {}, {}: error {:.3g}; predicted: {}{}\n", cell.method,
                        matrix.variants[cell.variant].label(), cell.setting, cell.error, cell.prediction.text,
                        cell.note.empty() ? "" : "; " + cell.note);
  }
  return text + fmt::format(
                    "passed {}, failed as predicted {}, not applicable {}, failed unexpectedly {}; over {:.0f} times "
                    "better than predicted {}, {} of them unexplained; {:.0f} s\n",
                    matrix.count(Outcome::Passed), matrix.count(Outcome::FailedAsPredicted),
                    matrix.count(Outcome::NotApplicable), matrix.count(Outcome::FailedUnexpectedly), surprisinglyGood,
                    matrix.betterThanPredicted(), unexplained(matrix).size(), seconds);
}

}  // namespace muelle::hard_cases
