#include "lab/hard_cases/running.h"

#include "engine/integrators/catalogue.h"

#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

namespace muelle::hard_cases {

namespace {

engine::RunOptions quiet(double duration) {
  engine::RunOptions options;
  options.duration = duration;
  options.keepStates = false;
  options.checkStability = false;
  options.checkNumericalDamping = false;
  options.explosion = std::numeric_limits<double>::infinity();
  return options;
}

}  // namespace

engine::RunOptions fixedStep(double h, double duration) {
  engine::RunOptions options = quiet(duration);
  options.h = h;
  options.fixedStep = true;
  return options;
}

engine::RunOptions blindStep(double h, double duration) {
  engine::RunOptions options = fixedStep(h, duration);
  options.locateEvents = false;
  return options;
}

engine::RunOptions withTolerance(double tolerance, double duration) {
  engine::RunOptions options = quiet(duration);
  options.tolerance.relative = tolerance;
  return options;
}

Finished run(const engine::Model& model, engine::Integrator& method, const engine::RunOptions& options) {
  Finished done;
  done.system = engine::build(model);
  done.result = engine::simulate(*done.system, method, done.system->initialState(), options);
  return done;
}

Finished run(const engine::Model& model, std::string_view method, const engine::RunOptions& options) {
  return run(model, *engine::makeMethod(method), options);
}

State bareSteps(const engine::DynamicalSystem& system, engine::Integrator& method, State state, double h,
                long long steps) {
  method.prepare(system, {});
  State next = state;
  for (long long n = 0; n < steps; ++n) {
    if (!method.step(system, state, h, next).done) return state;
    method.accept();
    std::swap(state, next);
    if (system.switching() != nullptr) system.switching()->commit(state, false);
  }
  return state;
}

bool longRuns() {
  const char* asked = std::getenv("MUELLE_LONG");
  return asked != nullptr && *asked != '\0' && std::string_view(asked) != "0";
}

double relative(double value, double expected) { return std::abs(value / expected - 1.0); }

}  // namespace muelle::hard_cases
