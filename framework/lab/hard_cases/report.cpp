#include "engine/integrators/catalogue.h"
#include "lab/hard_cases/matrix.h"
#include "lab/hard_cases/million_periods.h"
#include "lab/hard_cases/references.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <map>

namespace muelle::hard_cases {

namespace {

std::string number(double error) { return std::isfinite(error) ? fmt::format("{:.0e}", error) : "stopped"; }

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

/// Short names for the columns: "explicit_euler" -> "EE".
std::string shortName(const std::string& id) {
  static const std::map<std::string, std::string> names = {{"explicit_euler", "EE"},
                                                           {"symplectic_euler", "SE"},
                                                           {"explicit_midpoint", "EM"},
                                                           {"velocity_verlet", "VV"},
                                                           {"rattle", "RATTLE"},
                                                           {"runge_kutta_4", "RK4"},
                                                           {"dormand_prince_5", "DP5"},
                                                           {"dop853", "DOP853"},
                                                           {"nystrom8", "RKN8"},
                                                           {"nystrom12", "RKN12"},
                                                           {"yoshida4", "Y4"},
                                                           {"kahan_li_8", "KL8"},
                                                           {"rkc2", "RKC2"},
                                                           {"backward_euler", "BE"},
                                                           {"bdf2", "BDF2"},
                                                           {"tr_bdf2", "TRB2"},
                                                           {"esdirk4", "ESD4"},
                                                           {"linearised_backward_euler", "LBE"},
                                                           {"newmark", "NM"},
                                                           {"implicit_midpoint", "IM"},
                                                           {"discrete_gradient", "DG"},
                                                           {"xpbd", "XPBD"},
                                                           {"projective_dynamics", "PD"},
                                                           {"tr_bdf2", "TRB"},
                                                           {"rattle", "RAT"}};
  const auto found = names.find(id);
  return found == names.end() ? id : found->second;
}

/// A CSV field: quoted, quotes doubled.
std::string field(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"') out += '"';
    out += c == '\n' ? ' ' : c;
  }
  return out + "\"";
}

/// In a table of Markdown a bar would end the cell.
std::string inTable(std::string text) {
  std::ranges::replace(text, '|', '/');
  return text;
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

}  // namespace

std::string cellText(const Cell& cell) {
  switch (cell.outcome) {
    case Outcome::Passed:
      return number(cell.error);
    case Outcome::FailedAsPredicted:
      return "~" + number(cell.error);
    case Outcome::NotApplicable:
      return "n/a";
    case Outcome::FailedUnexpectedly:
      return "!" + number(cell.error);
  }
  return "";
}

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
    csv += fmt::format("{},{},{},{},{},{:.3g},{},{:.4g},{},{:.3g},{},{},{},{},{},{},{:.3f}\n", v.id, field(v.name),
                       cell.method, field(cell.setting), field(v.measured), v.bar, wordOf(cell.outcome), cell.error,
                       expected, cell.prediction.error, cell.betterThanPredicted ? "yes" : "no",
                       field(predictionRules()[static_cast<std::size_t>(cell.prediction.rule)].name),
                       field(cell.prediction.text), field(cell.note), cell.work.forceEvaluations, cell.work.steps,
                       cell.seconds);
  }
  return csv;
}

std::string matrixPage(const Matrix& matrix) {
  std::string page =
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
      "| ! | failed unexpectedly: there should be none |\n\n"
      "| case | bar |";
  for (const std::string& method : matrix.methods) page += fmt::format(" {} |", shortName(method));
  page += "\n|---|---|";
  for (std::size_t m = 0; m < matrix.methods.size(); ++m) page += "---|";
  page += "\n";
  for (std::size_t v = 0; v < matrix.variants.size(); ++v) {
    page += fmt::format("| {} | {:.0e} |", matrix.variants[v].label(), matrix.variants[v].bar);
    for (std::size_t m = 0; m < matrix.methods.size(); ++m) page += fmt::format(" {} |", cellText(matrix.at(m, v)));
    page += "\n";
  }
  page += fmt::format(
      "\nPassed {}, failed as predicted {}, not applicable {}, failed unexpectedly {}. More than "
      "100 times better than predicted: {}.\n",
      matrix.count(Outcome::Passed), matrix.count(Outcome::FailedAsPredicted), matrix.count(Outcome::NotApplicable),
      matrix.count(Outcome::FailedUnexpectedly), matrix.betterThanPredicted());
  page += h01Section() + realTimeSection(matrix) + sensitivitySection(matrix);
  page += "\n## The methods\n\n| column | method |\n|---|---|\n";
  for (const std::string& id : matrix.methods) {
    page += fmt::format("| {} | {} (`{}`) |\n", shortName(id), engine::methodInfo(id).name, id);
  }
  page +=
      "\n## The cases\n\n| case | what is right | measured | steps: explicit order 1 and 2, order 4, order 8; "
      "implicit; "
      "tolerance |\n|---|---|---|---|\n";
  for (const Variant& v : matrix.variants) {
    const auto facts = std::ranges::find(allCases(), v.id, &CaseFacts::id);
    page += fmt::format("| {} {} | {} | {} | {:.4g} s, {:.4g} s, {:.4g} s; {:.4g} s; {:.0e} |\n", v.label(),
                        facts->name, inTable(facts->correct), v.measured, v.steps.first, v.steps.fourth, v.steps.eighth,
                        v.steps.implicit, v.steps.tolerance);
  }
  page +=
      "\n## The rules of prediction\n\nAsked in this order; the first that applies decides.\n\n"
      "| rule | why | cells |\n|---|---|---|\n";
  for (std::size_t r = 0; r < predictionRules().size(); ++r) {
    const auto cells = std::ranges::count_if(
        matrix.cells, [r](const Cell& cell) { return cell.prediction.rule == static_cast<int>(r); });
    page += fmt::format("| {} | {} | {} |\n", predictionRules()[r].name, inTable(predictionRules()[r].reason), cells);
  }
  page +=
      "\n## Failed as predicted, and why\n\n| case | method | setting | error | prediction |\n|---|---|---|---|---|\n";
  for (const Cell& cell : matrix.cells) {
    if (cell.outcome != Outcome::FailedAsPredicted) continue;
    page += fmt::format("| {} | {} | {} | {} | {}: {} |\n", matrix.variants[cell.variant].label(),
                        shortName(cell.method), cell.setting, number(cell.error),
                        predictionRules()[static_cast<std::size_t>(cell.prediction.rule)].name,
                        inTable(cell.prediction.text));
  }
  page +=
      "\n## Better than predicted\n\nMore than 100 times; at most five, each with its reason.\n\n"
      "| case | method | error | foreseen | why |\n|---|---|---|---|---|\n";
  for (const Cell& cell : matrix.cells) {
    if (!cell.betterThanPredicted) continue;
    const std::string reason = reasonOf(matrix, cell);
    page += fmt::format("| {} | {} | {} | {} | {} |\n", matrix.variants[cell.variant].label(), shortName(cell.method),
                        number(cell.error), number(cell.prediction.error),
                        reason.empty() ? "not known: " + inTable(cell.prediction.text) : reason);
  }
  page += "\n## Not applicable\n\n| case | method | missing |\n|---|---|---|\n";
  for (const Cell& cell : matrix.cells) {
    if (cell.outcome != Outcome::NotApplicable) continue;
    page += fmt::format("| {} | {} | {} |\n", matrix.variants[cell.variant].label(), shortName(cell.method),
                        inTable(cell.prediction.text));
  }
  return page;
}

Figure matrixFigure(const Matrix& matrix) {
  Figure figure("hard_cases", "Methods fail where it was predicted (numbers: power of ten of the error)", "");
  figure.slide();
  struct Category {
    const char* name;
    int colour;
    std::vector<double> x = {}, y = {};
  };
  Category categories[] = {
      {"passed, 100 times below the bar", 5}, {"passed", 2}, {"failed as predicted", 4}, {"failed unexpectedly", 1}};
  const auto rows = matrix.variants.size();
  std::vector<std::string> methodNames, variantNames;
  for (const std::string& method : matrix.methods) methodNames.push_back(shortName(method));
  for (std::size_t v = rows; v-- > 0;) variantNames.push_back(matrix.variants[v].label());
  auto panel = figure.panel("");
  for (std::size_t m = 0; m < matrix.methods.size(); ++m) {
    for (std::size_t v = 0; v < rows; ++v) {
      const Cell& cell = matrix.at(m, v);
      const double x = static_cast<double>(m), y = static_cast<double>(rows - 1 - v);
      if (cell.outcome == Outcome::NotApplicable) {
        panel.note(x, y, "n/a", true);
        continue;
      }
      const bool ample = cell.error < 0.01 * matrix.variants[v].bar;
      Category& category = cell.outcome == Outcome::Passed              ? categories[ample ? 0 : 1]
                           : cell.outcome == Outcome::FailedAsPredicted ? categories[2]
                                                                        : categories[3];
      category.x.push_back(x);
      category.y.push_back(y);
      const std::string power = !std::isfinite(cell.error) ? "stop"
                                : cell.error == 0.0        ? "exact"
                                                           : fmt::format("{:.0f}", std::floor(std::log10(cell.error)));
      panel.note(x, y, power, true);
    }
  }
  for (Category& category : categories) {
    if (category.x.empty()) continue;
    panel.cells(category.name, category.x, category.y).colour(category.colour);
  }
  panel.xNames(methodNames).yNames(variantNames);
  return figure;
}

}  // namespace muelle::hard_cases
