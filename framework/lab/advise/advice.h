#pragma once
#include "engine/scene/scene.h"
#include "lab/advise/method_search.h"

#include <functional>
#include <string>
#include <vector>

namespace muelle::lab {

/// What is asked of the adviser.
struct AdviceOptions {
  double tolerance = 1e-4;  ///< the error that is allowed, in parts of the motion, as `muelle run` prints it
  double budget = 10.0;     ///< [s] of the clock on the wall for all of the advice
  std::function<void(double fraction)> progress = [](double) {};
};

/// The cheapest way found to run a scene within an error, or why nothing can be said.
struct Advice {
  double tolerance = 0.0, budget = 0.0;
  std::string refusal;  ///< why there is no statement, one line; empty when there is a choice
  ReferenceMotion reference;
  EnergyShare share;
  UnitCosts costs;
  MethodChoice methods;
  double growth = 0.0;   ///< of a small disturbance of the start, where it was looked for; else 0
  double seconds = 0.0;  ///< of the clock on the wall, of all of it

  const Candidate* chosen() const { return refusal.empty() ? methods.chosen() : nullptr; }
};

/// Throws std::invalid_argument on a tolerance or a budget that makes no sense, naming the option.
Advice advise(const engine::Scene& scene, const AdviceOptions& options);

/// What `muelle advise` prints.
std::string adviceText(const engine::Scene& scene, const Advice& advice);

}  // namespace muelle::lab
