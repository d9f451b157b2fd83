#include "base/text/count.h"
#include "engine/integrators/catalogue.h"
#include "lab/advise/advice.h"
#include "lab/bench/report.h"
#include "lab/run/summary_line.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

namespace muelle::lab {

namespace {

std::string durationText(double seconds) { return std::isfinite(seconds) ? bench::timeText(seconds) : "-"; }

/// "0.042 %", "1.4 %", "100 %".
std::string percentText(double share) {
  return share >= 0.1 ? fmt::format("{:.0f} %", 100.0 * share) : fmt::format("{:.2g} %", 100.0 * share);
}

std::string fateText(const Candidate& candidate) {
  using Fate = Candidate::Fate;
  if (candidate.fate == Fate::Chosen) return "chosen";
  if (candidate.fate == Fate::Keeps) return "keeps it, slower";
  return candidate.why;
}

std::string rowOf(const Candidate& candidate) {
  const std::string error = std::isfinite(candidate.error) ? fmt::format("{:.2g}", candidate.error) : "-";
  const std::string order = candidate.orderSeen > 0.0 ? fmt::format("{:.1f}", candidate.orderSeen) : "-";
  return fmt::format("  {:<26} {:<19} {:>8} {:>6} {:>10}  {}\n", candidate.setting.name(),
                     candidate.setting.valueText(), error, order, durationText(candidate.seconds), fateText(candidate));
}

/// Words in lines of at most 120 columns, below each other.
std::string wrapped(const char* name, const std::vector<std::string>& items) {
  std::string text, current;
  const auto flush = [&] {
    text += summaryLine(text.empty() ? name : "", current);
    current.clear();
  };
  for (std::size_t i = 0; i < items.size(); ++i) {
    const std::string item = items[i] + (i + 1 < items.size() ? "," : "");
    if (!current.empty() && current.size() + item.size() > 104) flush();
    current += (current.empty() ? "" : " ") + item;
  }
  flush();
  return text;
}

/// "Takahashi-Imada needs a force that does not depend on the velocity: remove ..." without the name and the advice,
/// which is for whoever wants that very method.
std::string shortReason(const Candidate& candidate) {
  std::string reason = candidate.why.substr(0, candidate.why.find(':'));
  const std::string& name = engine::methodInfo(candidate.setting.method).name;
  for (const std::string& begin : {name, candidate.setting.method}) {
    if (reason.starts_with(begin + " ")) reason = reason.substr(begin.size() + 1);
  }
  return reason;
}

/// A line for each reason for which candidates were left out, with their names.
std::string leftOut(const std::vector<Candidate>& candidates, Candidate::Fate fate, const char* name) {
  std::vector<std::string> reasons, items;
  for (const Candidate& candidate : candidates) {
    if (candidate.fate != fate) continue;
    const std::string reason = shortReason(candidate);
    if (std::ranges::find(reasons, reason) == reasons.end()) reasons.push_back(reason);
  }
  std::string text;
  for (const std::string& reason : reasons) {
    items.clear();
    for (const Candidate& candidate : candidates) {
      if (candidate.fate != fate || shortReason(candidate) != reason) continue;
      const bool timed = fate == Candidate::Fate::NotRun && std::isfinite(candidate.seconds);
      items.push_back(candidate.setting.name() + (timed ? fmt::format(" ({})", durationText(candidate.seconds)) : ""));
    }
    items.front() = reason + ": " + items.front();
    text += wrapped(text.empty() ? name : "", items);
  }
  return text;
}

std::string partRow(const PartTrial& trial) {
  const std::string error = std::isfinite(trial.error) ? fmt::format("{:.2g}", trial.error) : "-";
  const std::string saves = trial.measured ? fmt::format("{:.0f} %", 100.0 * (1.0 - trial.timeLeft)) : "-";
  return fmt::format("  {:<26} {:<19} {:>8} {:>6}  {}\n", trial.part.name, trial.leftOut ? "left out" : "kept", error,
                     saves, trial.why);
}

std::string partsTable(const Advice& advice) {
  if (advice.parts.empty()) return "";
  std::string text =
      fmt::format("  {:<26} {:<19} {:>8} {:>6}  {}\n", "part of the model", "decided", "error <=", "saves", "why");
  for (const PartTrial& trial : advice.parts) text += partRow(trial);
  return text + "  (each left out on its own: saves time at the setting that is best for the whole model)\n";
}

/// What is told and changes nothing in the file.
std::string factsText(const Advice& advice) {
  std::string text;
  for (const ClosedForm& form : advice.forms) {
    const std::string error = std::isfinite(form.error) ? fmt::format("error at most about {:.2g}, ", form.error) : "";
    text += summaryLine("fact", form.holds ? fmt::format("{} would do, {}{}", form.name, error, form.why)
                                           : fmt::format("{} would not do: {}", form.name, form.why));
  }
  if (advice.islands > 1) {
    text += summaryLine(
        "fact", fmt::format("{} groups of nodes do not act on each other: run apart, each may take steps of its own",
                            advice.islands));
  }
  return text;
}

std::string methodsTable(const std::vector<Candidate>& candidates) {
  if (candidates.empty()) return "";
  std::string text = fmt::format("  {:<26} {:<19} {:>8} {:>6} {:>10}  {}\n", "method", "step or tolerance",
                                 "error <=", "order", "time", "decided");
  for (const Candidate& candidate : candidates) text += candidate.runs > 0 ? rowOf(candidate) : "";
  text += fmt::format("  (error: at most about, {} times what was found; order: as seen in two runs)\n", statedFactor);
  text += leftOut(candidates, Candidate::Fate::NotRun, "not run");
  return text + leftOut(candidates, Candidate::Fate::Unfit, "unfit");
}

std::string chosenLine(const Advice& advice, const Candidate& chosen) {
  std::string text = fmt::format("{}, {}", chosen.setting.name(), chosen.setting.valueText());
  std::string names;
  for (const Simplification& part : advice.leftOut()) names += (names.empty() ? "" : ", ") + part.name;
  if (!names.empty()) text += ", without " + names;
  text += fmt::format(": error at most about {:.2g}, {}", chosen.error, durationText(chosen.seconds));
  if (!names.empty()) text += fmt::format(" (the whole model {})", durationText(advice.whole.chosen()->seconds));
  return text;
}

}  // namespace

std::string adviceText(const engine::Scene& scene, const Advice& advice) {
  std::string text = fmt::format("{}: {}\n", scene.name, scene.title);
  text += summaryLine(
      "asked", fmt::format("an error of at most {:.2g} of the motion over {:.4g} s", advice.tolerance, scene.duration));
  if (const Candidate* chosen = advice.chosen(); chosen != nullptr) {
    text += summaryLine("advice", chosenLine(advice, *chosen));
  } else {
    text += summaryLine("advice", fmt::format("no statement at {:.2g}: {}", advice.tolerance, advice.refusal));
  }
  if (!advice.reference.how.empty()) {
    text += summaryLine(
        "held", fmt::format("against {}: the two differ by {:.1g}", advice.reference.how, advice.reference.doubt));
    text += summaryLine("energy",
                        fmt::format("{} of it above a quarter of the highest frequency, {:.3g} Hz",
                                    percentText(advice.share.aboveQuarter), advice.share.fastest / 6.283185307179586));
    std::string costs = fmt::format("an evaluation of the force {}", durationText(advice.costs.evaluation));
    if (advice.costs.factorisation > 0.0) {
      costs += fmt::format(", a step with a factorisation {}", durationText(advice.costs.factorisation));
    }
    text += summaryLine("unit costs", costs);
  }
  text += partsTable(advice) + factsText(advice) + methodsTable(advice.methods.candidates);
  std::string cost = fmt::format("{:.2g} s of a budget of {:.3g} s", advice.seconds, advice.budget);
  if (advice.whole.outOfTime || advice.methods.outOfTime) cost += ", which ended the search";
  return text + summaryLine("cost", cost);
}

}  // namespace muelle::lab
