#include "base/text/count.h"
#include "lab/advise/advice.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

namespace muelle::lab {

namespace {

std::string line(const char* name, const std::string& text) { return fmt::format("  {:<11} {}\n", name, text); }

/// "12 us", "3.4 ms", "56 s".
std::string durationText(double seconds) {
  if (!std::isfinite(seconds)) return "-";
  if (seconds < 1e-6) return fmt::format("{:.3g} ns", 1e9 * seconds);
  if (seconds < 1e-3) return fmt::format("{:.3g} us", 1e6 * seconds);
  if (seconds < 1.0) return fmt::format("{:.3g} ms", 1e3 * seconds);
  return fmt::format("{:.3g} s", seconds);
}

std::string fateText(const Candidate& candidate) {
  using Fate = Candidate::Fate;
  switch (candidate.fate) {
    case Fate::Chosen:
      return "chosen";
    case Fate::Keeps:
      return "keeps it, slower";
    case Fate::Missed:
      return "left: " + candidate.why;
    case Fate::NotRun:
      return "not run: " + candidate.why;
    case Fate::Unfit:
      return candidate.why;
  }
  return {};
}

std::string rowOf(const Candidate& candidate) {
  const bool run = candidate.runs > 0;
  const bool fits = candidate.estimate.fits();
  const std::string error = std::isfinite(candidate.error) ? fmt::format("{:.2g}", candidate.error) : "-";
  const std::string order = candidate.orderSeen > 0.0 ? fmt::format("{:.1f}", candidate.orderSeen) : "-";
  const std::string time = fits ? (run ? "" : "~") + durationText(candidate.seconds) : "-";
  return fmt::format("  {:<26} {:<19} {:>8} {:>6} {:>10}  {}\n", candidate.setting.name(),
                     fits ? candidate.setting.valueText() : "-", error, order, time, fateText(candidate));
}

}  // namespace

std::string adviceText(const engine::Scene& scene, const Advice& advice) {
  std::string text = fmt::format("{}: {}\n", scene.name, scene.title);
  text += line("asked",
               fmt::format("an error of at most {:.2g} of the motion over {:.4g} s", advice.tolerance, scene.duration));
  if (const Candidate* chosen = advice.chosen(); chosen != nullptr) {
    text += line("advice", fmt::format("{}, {}: error at most about {:.2g}, {}", chosen->setting.name(),
                                       chosen->setting.valueText(), chosen->error, durationText(chosen->seconds)));
  } else {
    text += line("advice", fmt::format("no statement at {:.2g}: {}", advice.tolerance, advice.refusal));
  }
  if (advice.reference.stands()) {
    text +=
        line("held", fmt::format("against {}, which differ by {:.1g}", advice.reference.how, advice.reference.doubt));
    text += line("energy", fmt::format("{:.2g} % of it above a quarter of the highest frequency, {:.3g} Hz",
                                       100.0 * advice.share.aboveQuarter, advice.share.fastest / 6.283185307179586));
    std::string costs = fmt::format("an evaluation of the force {}", durationText(advice.costs.evaluation));
    if (advice.costs.factorisation > 0.0) {
      costs += fmt::format(", a step with a factorisation {}", durationText(advice.costs.factorisation));
    }
    text += line("unit costs", costs);
  }
  if (!advice.methods.candidates.empty()) {
    text += fmt::format("  {:<26} {:<19} {:>8} {:>6} {:>10}  {}\n", "method", "step or tolerance", "error <=", "order",
                        "time", "decided");
    for (const Candidate& candidate : advice.methods.candidates) text += rowOf(candidate);
    text += "  error <=: at most about, what was found times " + fmt::format("{}", statedFactor) +
            "; order: as seen; ~: foreseen\n";
  }
  std::string cost = fmt::format("{:.2g} s of a budget of {:.3g} s", advice.seconds, advice.budget);
  if (advice.methods.outOfTime) cost += ", which ended the search";
  return text + line("cost", cost);
}

}  // namespace muelle::lab
