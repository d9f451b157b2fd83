#pragma once
#include "engine/integrator.h"

#include <gtest/gtest.h>
#include <utility>
#include <vector>

namespace muelle::engine::testing {

inline State start(std::vector<double> x, std::vector<double> v = {}) {
  State state;
  state.v = v.empty() ? std::vector<double>(x.size(), 0.0) : std::move(v);
  state.x = std::move(x);
  return state;
}

/// Takes `steps` equal steps; every one must be done.
inline State run(const DynamicalSystem& system, Integrator& method, State state, double h, int steps) {
  method.prepare(system, {});
  State next = state;
  for (int i = 0; i < steps; ++i) {
    const StepResult result = method.step(system, state, h, next);
    if (!result.done) {
      ADD_FAILURE() << "step " << i << ": " << result.failure;
      return state;
    }
    method.accept();
    std::swap(state, next);
  }
  return state;
}

}  // namespace muelle::engine::testing
