#pragma once
#include "engine/control/simulate.h"
#include "engine/model/model_system.h"

#include <memory>
#include <string_view>

namespace muelle::hard_cases {

/// A finished run with its system.
struct Finished {
  std::unique_ptr<engine::ModelSystem> system;
  engine::RunResult result;

  Vec3 x(int node) const { return system->position(result.last, node); }
  Vec3 v(int node) const { return system->velocity(result.last, node); }
  double energy() const { return system->totalEnergy(result.last); }
};

/// Options of a run at a fixed step: no step control even with an error estimate, only the last state is kept, no
/// advice (the cases go where advice would warn), and no stop before the numbers end being finite.
engine::RunOptions fixedStep(double h, double duration);
/// The same without events: an exploding node would stop at each passage through an anchor.
engine::RunOptions blindStep(double h, double duration);
/// Options of an adaptive run with this tolerance, likewise quiet.
engine::RunOptions withTolerance(double tolerance, double duration);

/// Builds the model and runs it from its own start.
Finished run(const engine::Model& model, engine::Integrator& method, const engine::RunOptions& options);
Finished run(const engine::Model& model, std::string_view method, const engine::RunOptions& options);

/// `steps` bare steps of h, without anything that simulate() adds: no events, no swept bound, no checks. Stops early
/// when a step fails. For the failures that simulate() prevents.
State bareSteps(const engine::DynamicalSystem& system, engine::Integrator& method, State state, double h,
                long long steps);

/// Deviation in parts of what is expected.
double relative(double value, double expected);

/// Whether long runs were asked for: the environment variable MUELLE_LONG is set and not "0".
bool longRuns();

}  // namespace muelle::hard_cases
