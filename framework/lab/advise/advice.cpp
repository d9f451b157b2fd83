#include "lab/advise/advice.h"

#include "lab/run/foresight.h"

#include <fmt/format.h>
#include <chrono>
#include <cmath>
#include <stdexcept>

namespace muelle::lab {

using namespace engine;

namespace {

using Clock = std::chrono::steady_clock;

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
  Adviser(const Scene& scene, const AdviceOptions& options) : scene_(scene), options_(options), begun_(Clock::now()) {
    advice_.tolerance = options.tolerance;
    advice_.budget = options.budget;
  }

  Advice give() {
    consider();
    options_.progress(1.0);
    advice_.seconds = passed();
    return std::move(advice_);
  }

 private:
  double passed() const { return std::chrono::duration<double>(Clock::now() - begun_).count(); }
  double left() const { return options_.budget - passed(); }

  void consider() {
    const std::unique_ptr<ModelSystem> system = build(scene_.model);
    const Pilots pilots(scene_, *system);
    advice_.reference = findReference(pilots, options_.tolerance, 0.6 * left());
    options_.progress(0.3);
    if (!advice_.reference.stands()) return refuse(pilots);
    advice_.costs = unitCosts(pilots);
    advice_.share = energyShare(*system, advice_.reference.run.states);
    const auto estimates = estimateMethods(pilots, advice_.share, options_.tolerance);
    options_.progress(0.4);
    advice_.methods = chooseMethod(pilots, advice_.reference, estimates, options_.tolerance, 0.0, left(),
                                   [this](double part) { options_.progress(0.4 + 0.6 * part); });
    if (advice_.methods.chosen() == nullptr) {
      advice_.refusal =
          advice_.methods.outOfTime
              ? fmt::format("no method was seen to keep it in the {:.3g} s of the budget: give a larger --budget",
                            options_.budget)
              : "no method keeps it";
    }
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
  Clock::time_point begun_;
  Advice advice_;
};

}  // namespace

Advice advise(const Scene& scene, const AdviceOptions& options) {
  checkOptions(options);
  requireMemory(scene, foresee(scene), availableMemory());
  return Adviser(scene, options).give();
}

}  // namespace muelle::lab
