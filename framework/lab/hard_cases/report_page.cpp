#include "engine/integrators/catalogue.h"
#include "lab/hard_cases/cell_text.h"
#include "lab/hard_cases/million_periods.h"
#include "lab/hard_cases/references.h"
#include "lab/hard_cases/report.h"

#include <fmt/format.h>
#include <algorithm>

namespace muelle::hard_cases {

namespace {

/// In a table of Markdown a bar would end the cell.
std::string inTable(std::string text) {
  std::ranges::replace(text, '|', '/');
  return text;
}

constexpr const char* introduction =
    "# Hard cases {#hard_cases}\n\n"
    "Twenty-four problems with known answers (`framework/lab/hard_cases/cases.json`), and every method of the engine "
    "on "
    "each. "
    "`./muelle hard-cases --out DIR` runs them and writes this page and its figure.\n\n"
    "![Every method on every case](hard_cases.svg)\n\n"
    "A cell shows the error in the case's own measure. Before it runs, the outcome is predicted from what the method "
    "says of itself and from the case's frequencies, dampings and sensitivity, by the rules below. A prediction has "
    "two "
    "sides: an error beyond the bar that was not foreseen is a failure of the engine or of the rules, and so is one "
    "more than 100 times below what was foreseen.\n\n"
    "| cell | meaning |\n|---|---|\n"
    "| 2e-09 | passed: the error is within the case's bar |\n"
    "| ~2e-01 | failed as predicted |\n"
    "| n/a | not applicable: the system lacks what the method needs |\n"
    "| ! | failed unexpectedly: there should be none |\n\n";

std::string tableSection(const Matrix& matrix) {
  std::string page = "| case | bar |";
  for (const std::string& method : matrix.methods) page += fmt::format(" {} |", shortName(method));
  page += "\n|---|---|";
  for (std::size_t m = 0; m < matrix.methods.size(); ++m) page += "---|";
  page += "\n";
  for (std::size_t v = 0; v < matrix.variants.size(); ++v) {
    page += fmt::format("| {} | {:.0e} |", matrix.variants[v].label(), matrix.variants[v].bar);
    for (std::size_t m = 0; m < matrix.methods.size(); ++m) page += fmt::format(" {} |", cellText(matrix.at(m, v)));
    page += "\n";
  }
  return page;
}

std::string countsSection(const Matrix& matrix) {
  return fmt::format(
      "\nPassed {}, failed as predicted {}, not applicable {}, failed unexpectedly {}. More than "
      "100 times better than predicted: {}.\n",
      matrix.count(Outcome::Passed), matrix.count(Outcome::FailedAsPredicted), matrix.count(Outcome::NotApplicable),
      matrix.count(Outcome::FailedUnexpectedly), matrix.betterThanPredicted());
}

std::string h01Section() {
  const H01InFull full = keptH01InFull();
  return fmt::format(
      "\n## H01 in full\n\nThe oscillator over its million periods, 62,831,853 steps of 0.1 s, each method against its "
      "own discrete solution. Run on {} by `./muelle hard-cases --full H01 --out DIR` (minutes); the numbers are kept "
      "in "
      "`framework/lab/hard_cases/h01_in_full.json`, and `MUELLE_LONG=1` runs them in the tests. Explicit and backward "
      "Euler are run as far as a double goes, and carried on at the same rate.\n\n"
      "![A million periods](hard_cases_h01.svg)\n\n{}",
      full.date, h01Table(full));
}

/// Which methods meet the bar of the cases that ask for real time, and in how much of the motion's time.
std::string realTimeSection(const Matrix& matrix) {
  std::string rows;
  for (std::size_t v = 0; v < matrix.variants.size(); ++v) {
    const Variant& variant = matrix.variants[v];
    if (!variant.realTime) continue;
    std::string within;
    for (std::size_t m = 0; m < matrix.methods.size(); ++m) {
      const Cell& cell = matrix.at(m, v);
      if (cell.outcome != Outcome::Passed || cell.processorSeconds > variant.duration) continue;
      within += fmt::format("{}{} {:.1g}", within.empty() ? "" : ", ", shortName(cell.method),
                            cell.processorSeconds / variant.duration);
    }
    rows += fmt::format("| {} | {:.0e} m | {} |\n", variant.label(), variant.bar, within.empty() ? "none" : within);
  }
  if (rows.empty()) return "";
  return "\n## In real time\n\nMethods that meet the bar in no more processor time than the motion takes, with the "
         "part "
         "of it that they took in the run of this page.\n\n| case | bar | methods |\n|---|---|---|\n" +
         rows;
}

/// What was computed of the cases' own motions.
std::string sensitivitySection(const Matrix& matrix) {
  std::string page =
      "\n## Sensitivities\n\nComputed by moving the reference motion's state a little, at eight times, and going on to "
      "the end: the change of the case's number for a change of 1 m in any direction and for one along the motion "
      "(root "
      "mean squares over the times), and for a relative change of all speeds.\n\n"
      "| case | any | along | at the first time | speeds |\n|---|---|---|---|---|\n";
  for (const Variant& variant : matrix.variants) {
    if (!variant.sensitivity) continue;
    const Sensitivity& s = *variant.sensitivity;
    const Sensitivity::Growth growth = s.between(0.0, variant.duration);
    page += fmt::format("| {} | {:.2g} | {:.2g} | {:.2g} | {:.2g} |\n", variant.label(), growth.any, growth.along,
                        s.any.front(), s.perRelativeSpeed);
  }
  return page;
}

std::string methodsSection(const Matrix& matrix) {
  std::string page = "\n## The methods\n\n| column | method |\n|---|---|\n";
  for (const std::string& id : matrix.methods) {
    page += fmt::format("| {} | {} (`{}`) |\n", shortName(id), engine::methodInfo(id).name, id);
  }
  return page;
}

std::string casesSection(const Matrix& matrix) {
  std::string page =
      "\n## The cases\n\n| case | what is right | measured | steps: explicit order 1 and 2, order 4, order 8; "
      "implicit; "
      "tolerance (of order 2 its power 2/3) |\n|---|---|---|---|\n";
  for (const Variant& v : matrix.variants) {
    const auto facts = std::ranges::find(allCases(), v.id, &CaseFacts::id);
    page += fmt::format("| {} {} | {} | {} | {:.4g} s, {:.4g} s, {:.4g} s; {:.4g} s; {:.0e} |\n", v.label(),
                        facts->name, inTable(facts->correct), v.measured, v.steps.first, v.steps.fourth, v.steps.eighth,
                        v.steps.implicit, v.steps.tolerance);
  }
  return page;
}

std::string rulesSection(const Matrix& matrix) {
  std::string page =
      "\n## The rules of prediction\n\nAsked in this order; the first that applies decides.\n\n"
      "| rule | why | cells |\n|---|---|---|\n";
  for (std::size_t r = 0; r < predictionRules().size(); ++r) {
    const auto cells = std::ranges::count_if(
        matrix.cells, [r](const Cell& cell) { return cell.prediction.rule == static_cast<int>(r); });
    page += fmt::format("| {} | {} | {} |\n", predictionRules()[r].name, inTable(predictionRules()[r].reason), cells);
  }
  return page;
}

std::string foreseenSection(const Matrix& matrix) {
  std::string page =
      "\n## Failed as predicted, and why\n\n| case | method | setting | error | prediction |\n|---|---|---|---|---|\n";
  for (const Cell& cell : matrix.cells) {
    if (cell.outcome != Outcome::FailedAsPredicted) continue;
    page += fmt::format("| {} | {} | {} | {} | {}: {} |\n", matrix.variants[cell.variant].label(),
                        shortName(cell.method), cell.setting, errorText(cell.error),
                        predictionRules()[static_cast<std::size_t>(cell.prediction.rule)].name,
                        inTable(cell.prediction.text));
  }
  return page;
}

std::string surprisesSection(const Matrix& matrix) {
  std::string page =
      "\n## Better than predicted\n\nMore than 100 times; at most five, each with its reason.\n\n"
      "| case | method | error | foreseen | why |\n|---|---|---|---|---|\n";
  for (const Cell& cell : matrix.cells) {
    if (!cell.betterThanPredicted) continue;
    const std::string reason = reasonOf(matrix, cell);
    page += fmt::format("| {} | {} | {} | {} | {} |\n", matrix.variants[cell.variant].label(), shortName(cell.method),
                        errorText(cell.error), errorText(cell.prediction.error),
                        reason.empty() ? "not known: " + inTable(cell.prediction.text) : reason);
  }
  return page;
}

std::string notApplicableSection(const Matrix& matrix) {
  std::string page = "\n## Not applicable\n\n| case | method | missing |\n|---|---|---|\n";
  for (const Cell& cell : matrix.cells) {
    if (cell.outcome != Outcome::NotApplicable) continue;
    page += fmt::format("| {} | {} | {} |\n", matrix.variants[cell.variant].label(), shortName(cell.method),
                        inTable(cell.prediction.text));
  }
  return page;
}

}  // namespace

std::string matrixPage(const Matrix& matrix) {
  return introduction + tableSection(matrix) + countsSection(matrix) + h01Section() + realTimeSection(matrix) +
         sensitivitySection(matrix) + methodsSection(matrix) + casesSection(matrix) + rulesSection(matrix) +
         foreseenSection(matrix) + surprisesSection(matrix) + notApplicableSection(matrix);
}

}  // namespace muelle::hard_cases
