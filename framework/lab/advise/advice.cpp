#include "lab/advise/advice.h"

#include "lab/advise/countdown.h"
#include "lab/bench/statistics.h"
#include "lab/run/foresight.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace muelle::lab {

using namespace engine;

namespace {

void checkOptions(const AdviceOptions& options) {
  if (!(options.tolerance > 0.0 && options.tolerance <= 1.0)) {
    throw std::invalid_argument(
        fmt::format("--tolerance is {}; it is the error that is allowed in parts of the motion: above 0, at most 1",
                    options.tolerance));
  }
  if (!(options.budget > 0.0 && std::isfinite(options.budget))) {
    throw std::invalid_argument(fmt::format("--budget is {} s; it must be positive and finite", options.budget));
  }
}

/// Shares out the budget over what is done one after the other.
class Adviser {
 public:
  Adviser(const Scene& scene, const AdviceOptions& options) : scene_(scene), options_(options), clock_(options.budget) {
    advice_.tolerance = options.tolerance;
    advice_.budget = options.budget;
  }

  Advice give() {
    consider();
    options_.progress(1.0);
    advice_.seconds = clock_.passed();
    return std::move(advice_);
  }

 private:
  double left() const { return clock_.left(); }

  void consider() {
    const bool rubs =
        std::ranges::any_of(scene_.model.obstacles, [](const Obstacle& o) { return o.material.mu > 0.0; });
    if (rubs && !scene_.locateEvents) {
      advice_.refusal = "friction sticks and slips between steps, and no step tells by how much: set events = true";
      return;
    }
    const std::unique_ptr<ModelSystem> system = build(scene_.model);
    const Pilots pilots(scene_, *system);
    advice_.reference = findReference(pilots, options_.tolerance, 0.55 * left());
    options_.progress(0.3);
    if (!advice_.reference.stands()) return refuse(pilots);
    advice_.costs = unitCosts(pilots);
    advice_.share = shareOf(*system);
    advice_.forms = closedForms(pilots, advice_.reference, options_.tolerance);
    advice_.islands = islandsOf(scene_.model).size();
    advice_.whole = choose(pilots, pilots, 0.4 * left(), 0.35, 0.6);
    if (advice_.whole.chosen() == nullptr) return refuseMethods();
    advice_.parts =
        tryParts(pilots, advice_.reference, advice_.whole.chosen()->setting, options_.tolerance, 0.6 * left());
    options_.progress(0.7);
    settleModel(pilots);
    advice_.scene = withSetting(std::move(advice_.scene), advice_.methods.chosen()->setting);
  }

  EnergyShare shareOf(const ModelSystem& system) const {
    // A few of the states are enough to see where the energy is.
    const std::vector<State>& all = advice_.reference.run.states;
    std::vector<State> some;
    for (std::size_t i = 0; i < all.size(); i += (all.size() + 3) / 4) some.push_back(all[i]);
    return energyShare(system, some, advice_.reference.run.touches());
  }

  /// \param from, to  of the progress
  MethodChoice choose(const Pilots& pilots, const Pilots& whole, double seconds, double from, double to) {
    auto estimates = estimateMethods(pilots, advice_.share, advice_.costs, options_.tolerance);
    if (const Candidate* best = advice_.whole.chosen()) foresee(estimates, *best);
    const auto tell = [&](double part) { options_.progress(from + (to - from) * part); };
    return chooseMethod(pilots, whole, advice_.reference, estimates, options_.tolerance, seconds, tell);
  }

  /// What was best for the whole model is tried first on what is left of it, and foreseen to take as long.
  static void foresee(std::vector<MethodEstimate>& estimates, const Candidate& best) {
    const auto known = std::ranges::find_if(estimates, [&](const MethodEstimate& e) {
      return e.fits() && e.setting.method == best.setting.method && e.setting.fixed == best.setting.fixed;
    });
    if (known == estimates.end()) return;
    known->seconds = known->leastSeconds = best.seconds;
    std::rotate(estimates.begin(), known, known + 1);
  }

  /// Leaves out what was decided, and chooses anew where that makes another model.
  void settleModel(const Pilots& whole) {
    advice_.scene = scene_;
    advice_.methods = advice_.whole;
    while (true) {
      const std::vector<Simplification> parts =
          leaveOutTogether(whole, advice_.reference, advice_.parts, options_.tolerance, 0.5 * left());
      if (parts.empty()) return;
      const Scene rest = without(scene_, parts);
      const std::unique_ptr<ModelSystem> system = build(rest.model);
      const Pilots pilots(rest, *system, &scene_.model.obstacles);
      MethodChoice choice = choose(pilots, whole, left(), 0.7, 1.0);
      if (choice.chosen() == nullptr || isSlower(whole, pilots, choice)) {
        keepAll(choice.chosen() == nullptr ? "no method was seen to keep the error without it"
                                           : "without it the run was seen to be slower");
        return;
      }
      if (!keepsAway(pilots, choice.chosen()->setting, parts)) continue;
      advice_.scene = rest;
      advice_.methods = std::move(choice);
      climb(whole, parts);
      return;
    }
  }

  /// Times both choices in turn. What is about as fast is left out as well: a smaller model is easier to look at. Only
  /// a rest that is slower in nearly every pair speaks against it: on a busy machine a median of seven is no proof.
  bool isSlower(const Pilots& whole, const Pilots& rest, MethodChoice& choice) {
    constexpr double asFast = 1.25;
    std::vector<double> before, after, ratios;
    for (int round = 0; round < 7 && (round == 0 || left() > 0.0); ++round) {
      before.push_back(whole.bareSeconds(advice_.whole.chosen()->setting));
      after.push_back(rest.bareSeconds(choice.chosen()->setting));
      ratios.push_back(after.back() / before.back());
    }
    advice_.whole.candidates.front().seconds = bench::statisticsOf(before).median;
    choice.candidates.front().seconds = bench::statisticsOf(after).median;
    return bench::statisticsOf(ratios).low > asFast;
  }

  void keepAll(const std::string& why) {
    for (PartTrial& trial : advice_.parts) {
      if (trial.leftOut) trial.why = why;
      trial.leftOut = false;
    }
  }

  /// Whether the advised run itself keeps away from the obstacles that were left out; one that it touches comes back.
  bool keepsAway(const Pilots& pilots, const Setting& setting, const std::vector<Simplification>& parts) {
    const bool watched =
        std::ranges::any_of(parts, [](const Simplification& p) { return p.kind == Simplification::Kind::Contact; });
    if (!watched) return true;
    const PilotRun run = pilots.run(setting, {.watchesGaps = true});
    bool all = true;
    for (PartTrial& trial : advice_.parts) {
      if (!trial.leftOut || trial.part.kind != Simplification::Kind::Contact) continue;
      if (run.leastGap[trial.part.obstacle] > 0.0) continue;
      trial.leftOut = all = false;
      trial.why = "the run without it comes too near";
    }
    return all;
  }

  /// The way from the whole model to the advised one, a part at a time.
  void climb(const Pilots& whole, const std::vector<Simplification>& parts) {
    const Candidate& before = *advice_.whole.chosen();
    addStep(whole, "whole model", whole, before.setting, before.seconds);
    std::vector<Simplification> gone;
    for (const Simplification& part : parts) {
      gone.push_back(part);
      const bool last = gone.size() == parts.size();
      const Scene rest = without(scene_, gone);
      const std::unique_ptr<ModelSystem> system = build(rest.model);
      const Pilots pilots(rest, *system);
      const Setting& aim = advice_.methods.chosen()->setting;
      const Setting setting = refusalOf(*system, aim.method).empty() ? aim : before.setting;
      addStep(whole, "without " + part.name, pilots, setting,
              last ? advice_.methods.chosen()->seconds : pilots.bareSeconds(setting));
    }
  }
  void addStep(const Pilots& whole, const std::string& name, const Pilots& pilots, const Setting& setting,
               double seconds) {
    const PilotRun run = pilots.run(setting, {});
    if (run.done()) advice_.ladder.push_back({name, setting, advice_.reference.errorOf(whole, run.rows), seconds});
  }

  void refuseMethods() {
    advice_.refusal =
        advice_.whole.outOfTime
            ? fmt::format("no method was seen to keep it in the {:.3g} s of the budget: give a larger --budget",
                          options_.budget)
            : "no method keeps it";
  }

  void refuse(const Pilots& pilots) {
    advice_.refusal = advice_.reference.failure;
    if (advice_.reference.outOfTime) {
      advice_.refusal += fmt::format(": give a larger --budget than {:.3g} s", options_.budget);
      return;
    }
    if (!advice_.reference.disagrees || left() <= 0.0) return;
    advice_.growth = growthOf(pilots, advice_.reference, -1, left());
    if (advice_.growth > 1e4) {
      advice_.refusal =
          fmt::format("a small difference of the start grows {:.1g} times: {}", advice_.growth, advice_.refusal);
    }
  }

  const Scene& scene_;
  const AdviceOptions& options_;
  Countdown clock_;
  Advice advice_;
};

}  // namespace

std::vector<Simplification> Advice::leftOut() const {
  std::vector<Simplification> all;
  for (const PartTrial& trial : parts) {
    if (trial.leftOut) all.push_back(trial.part);
  }
  return all;
}

Advice advise(const Scene& scene, const AdviceOptions& options) {
  checkOptions(options);
  requireMemory(scene, foresee(scene), availableMemory());
  return Adviser(scene, options).give();
}

}  // namespace muelle::lab
