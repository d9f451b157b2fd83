#include "base/text/csv.h"
#include "lab/hard_cases/report.h"

#include <fmt/format.h>

namespace muelle::hard_cases {

namespace {

const char* wordOf(Outcome outcome) {
  switch (outcome) {
    case Outcome::Passed:
      return "passed";
    case Outcome::FailedAsPredicted:
      return "failed as predicted";
    case Outcome::NotApplicable:
      return "not applicable";
    case Outcome::FailedUnexpectedly:
      return "failed unexpectedly";
  }
  return "";
}

}  // namespace

std::string matrixCsv(const Matrix& matrix) {
  std::string csv =
      "case,variant,method,setting,measured,bar,outcome,error,predicted,predicted_error,better_than_predicted,rule,"
      "prediction,note,"
      "force_evaluations,steps,seconds\n";
  for (const Cell& cell : matrix.cells) {
    const Variant& v = matrix.variants[cell.variant];
    const char* expected = cell.prediction.expectation == Expectation::Passes  ? "passes"
                           : cell.prediction.expectation == Expectation::Fails ? "fails"
                                                                               : "not applicable";
    csv += fmt::format("{},{},{},{},{},{:.3g},{},{:.4g},{},{:.3g},{},{},{},{},{},{},{:.3f}\n", v.id, csvField(v.name),
                       cell.method, csvField(cell.setting), csvField(v.measured), v.bar, wordOf(cell.outcome),
                       cell.error, expected, cell.prediction.error, cell.betterThanPredicted ? "yes" : "no",
                       csvField(predictionRules()[static_cast<std::size_t>(cell.prediction.rule)].name),
                       csvField(cell.prediction.text), csvField(cell.note), cell.work.forceEvaluations, cell.work.steps,
                       cell.seconds);
  }
  return csv;
}

}  // namespace muelle::hard_cases
