#include "engine/integrators/methods_page.h"

#include "engine/integrators/catalogue.h"
#include "engine/integrators/standing.h"

#include <fmt/format.h>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

namespace muelle::engine {

namespace {

std::string limitInWords(double limit) {
  if (std::isinf(limit)) return "none";
  return limit == 0.0 ? "0" : fmt::format("{:.4g}", limit);
}

/// Joins the words whose flag is set; `none` when there is none.
std::string chosen(const std::vector<std::pair<bool, std::string_view>>& words, std::string_view none) {
  std::string text;
  for (const auto& [isSet, word] : words) {
    if (!isSet) continue;
    if (!text.empty()) text += ", ";
    text += word;
  }
  return text.empty() ? std::string(none) : text;
}

std::string conservedBy(const MethodInfo& info) {
  return chosen({{info.conservesEnergy, "energy"},
                 {info.conservesMomentum, "momentum"},
                 {info.conservesAngularMomentum, "angular momentum"}},
                "nothing");
}

std::string neededBy(const MethodInfo& info) {
  return chosen({{info.needs.potential, "an energy"},
                 {info.needs.linearisation, "derivatives of the force"},
                 {info.needs.constraints && !info.needs.distanceConstraints, "constraints"},
                 {info.needs.distanceConstraints, "constraints, all of them distances"},
                 {info.needs.velocityFreeForce,
                  info.needs.dragAside ? "a force without velocity, drag aside" : "a force without velocity"}},
                "the force alone");
}

std::string characterOf(const MethodInfo& info) {
  return chosen({{info.symplectic, "symplectic"},
                 {info.reversible, "reversible"},
                 {info.adaptive, "adaptive"},
                 {info.holdsRods, "holds rods"},
                 {info.iterative, "stops before it converges"},
                 {info.stability == Stability::AStable, "A-stable"},
                 {info.stability == Stability::LStable, "L-stable"}},
                "-");
}

std::string costOf(const MethodInfo& info) { return info.stages > 0 ? std::to_string(info.stages) : "solve"; }

std::string whyItStays(const Standing& standing) {
  switch (standing.because) {
    case Standing::Because::Exercise:
      return fmt::format("the exercise {}", standing.where);
    case Standing::Because::Figure:
      return fmt::format("the figure {} of the lecture", standing.where);
    case Standing::Because::Plane:
      return fmt::format("the fastest of ours on the scene {} of ./muelle bench", standing.where);
    case Standing::Because::Alone:
      return std::string(standing.where);
  }
  return {};
}

/// What stays and why, and what has gone.
std::string standingsInWords() {
  std::string text =
      "\n## Which methods are here\n\nWhat wins an entry of the plane of speed against error, or stands in an exercise "
      "or a figure, or is the only one of its\nkind. The rest goes.\n\n| method | is here for |\n|---|---|\n";
  for (const Standing& standing : standings())
    text += fmt::format("| `{}` | {} |\n", standing.id, whyItStays(standing));
  text += "\nGone:\n\n";
  for (const GoneMethod& method : goneMethods()) {
    text += fmt::format("- `{}`; take `{}`. {}.\n", method.id, method.instead, method.why);
  }
  return text;
}

}  // namespace

std::string methodsPage() {
  std::string page =
      "# The methods {#methods}\n\n"
      "Made from `MethodInfo` of each method (`build/bin/muelle-methods-page docs/methods.md`), which also gives the\n"
      "predictions of the hard cases.\n"
      "Limits are of the step: `h omega` for an undamped oscillator, `h lambda` for v' = -lambda v.\n\n"
      "| method | order | force evaluations a step | limit of h omega | limit of h lambda | conserves | character |\n"
      "|---|---|---|---|---|---|---|\n";
  for (const std::string& id : methodIds()) {
    const MethodInfo& info = methodInfo(id);
    page += fmt::format("| {} `{}` | {} | {} | {} | {} | {} | {} |\n", info.name, id, info.order, costOf(info),
                        limitInWords(info.imaginaryLimit), limitInWords(info.realLimit), conservedBy(info),
                        characterOf(info));
  }
  page += standingsInWords();
  for (const std::string& id : methodIds()) {
    const MethodInfo& info = methodInfo(id);
    page += fmt::format("\n## {}\n\n`{}` needs {}.\n\n    {}\n\n{}\n\nSource: {}.\n", info.name, id, neededBy(info),
                        info.formula, info.remark, info.source);
  }
  return page;
}

}  // namespace muelle::engine
