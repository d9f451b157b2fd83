#pragma once
#include "engine/scene/scene.h"
#include "lab/advise/closed_form.h"
#include "lab/advise/method_search.h"
#include "lab/advise/part_trial.h"

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

/// A run of the scene with some of its parts left out, on the way from the whole model to the one that is advised.
struct LadderStep {
  std::string left;  ///< "whole model", "without drag"
  Setting setting;
  double error = 0.0;    ///< in parts of the motion of the whole model, as it was found
  double seconds = 0.0;  ///< of the processor
};

/// The cheapest way found to run a scene within an error, or why nothing can be said.
struct Advice {
  double tolerance = 0.0, budget = 0.0;
  std::string refusal;  ///< why there is no statement, one line; empty when there is a choice
  ReferenceMotion reference;
  EnergyShare share;
  UnitCosts costs;
  MethodChoice whole;              ///< methods for the whole model
  std::vector<PartTrial> parts;    ///< what could be left out of it
  std::vector<ClosedForm> forms;   ///< ways without a run
  std::size_t islands = 1;         ///< groups of nodes that do not act on each other
  engine::Scene scene;             ///< the scene that is advised: without these parts, by the chosen method
  MethodChoice methods;            ///< for that scene; their errors are those against the whole model
  std::vector<LadderStep> ladder;  ///< empty where nothing was left out
  double growth = 0.0;             ///< of a small disturbance of the start, where it was looked for; else 0
  double seconds = 0.0;            ///< of the clock on the wall, of all of it

  /// The parts that were left out.
  std::vector<Simplification> leftOut() const;
  const Candidate* chosen() const { return refusal.empty() ? methods.chosen() : nullptr; }
};

/// Throws std::invalid_argument on a tolerance or a budget that makes no sense, naming the option.
Advice advise(const engine::Scene& scene, const AdviceOptions& options);

/// What `muelle advise` prints.
std::string adviceText(const engine::Scene& scene, const Advice& advice);

}  // namespace muelle::lab
