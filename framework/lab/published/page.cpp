#include "lab/published/page.h"

#include "base/text/count.h"
#include "lab/published/problem.h"

#include <fmt/format.h>
#include <cmath>

namespace muelle::published {

namespace {

/// Seven digits: more than any source prints, fewer than a processor's round-off reaches.
std::string shown(double value) { return fmt::format("{:.7g}", value); }

/// What a printed value differs from the engine's by, in units of its last digit.
std::string difference(const Quantity& quantity, double ours) {
  const double digits = std::abs(ours - quantity.printedValue()) / quantity.lastDigit();
  return fmt::format("{:.2f}{}", digits, quantity.printedIsOff ? " (printed value off)" : "");
}

std::string entry(const Problem& problem) {
  std::string text = fmt::format("\n## {}: {}\n\nSource: {}.\n\nGiven: {}.\n", problem.id, problem.title,
                                 problem.source, problem.setting);
  if (!problem.model.empty()) text += fmt::format("\nHere: {}.\n", problem.model);
  text += "\n| value | unit | printed | ours | exact | difference in last digits |\n|---|---|---|---|---|---|\n";
  const std::vector<double> ours = problem.solve();
  for (std::size_t i = 0; i < problem.quantities.size(); ++i) {
    const Quantity& q = problem.quantities[i];
    text += fmt::format("| {} | {} | {} | {} | {} | {} |\n", q.what, q.unit, q.printed, shown(ours.at(i)),
                        shown(q.exact), difference(q, ours[i]));
  }
  return text;
}

}  // namespace

std::string publishedPage() {
  std::string entries;
  int values = 0;
  int off = 0;
  const std::vector<Problem> all = problems();
  for (const Problem& problem : all) {
    entries += entry(problem);
    values += static_cast<int>(std::ssize(problem.quantities));
    for (const Quantity& q : problem.quantities) off += q.printedIsOff ? 1 : 0;
  }
  return fmt::format(
             "# Published problems {{#published}}\n\n"
             "Spring-mass problems of verification manuals and textbooks, solved by the engine\n"
             "(`build/bin/muelle-published-page docs/published.md`; `framework/lab/published/` has them as data). "
             "Facts and\n"
             "figures are the sources', in their units. *Exact* is our own value, of the closed form or of an "
             "independent solution. The difference of "
             "printed\n"
             "and ours is in units of the last digit printed: up to 0.5 is rounding. Where it is more, the printed "
             "value is off\n"
             "and not ours, as the exact one shows.\n\n"
             "{}, {}; {} printed off.\n",
             counted(std::ssize(all), "problem"), counted(values, "value"), off) +
         entries;
}

}  // namespace muelle::published
