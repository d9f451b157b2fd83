#pragma once
/// \file
/// Scenes with a known answer, and a bare loop of steps.

#include "engine/integrators/catalogue.h"
#include "engine/model/model_system.h"

#include <gtest/gtest.h>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace muelle::engine::testing {

/// A scene whose exact state is known at every time.
struct ExactScene {
  std::unique_ptr<ModelSystem> system;
  State start;
  std::function<State(double t)> exact;
};

/// 1D: mass 1 on a spring with k = 1, L0 = 1 from a pinned node: x = 1 + A cos t + B sin t.
inline ExactScene oscillator() {
  Model model;
  model.dimension = 1;
  const double a = 0.4, b = 0.3;
  model.nodes = {{.x = Vec3(0.0, 0.0, 0.0), .pinned = true}, {.x = Vec3(1.0 + a, 0.0, 0.0), .v = Vec3(b, 0.0, 0.0)}};
  model.springs = {{.a = 0, .b = 1, .k = 1.0, .L0 = 1.0}};
  ExactScene scene;
  scene.system = build(model);
  scene.start = scene.system->initialState();
  scene.exact = [a, b](double t) {
    return State{
        .t = t, .x = {1.0 + a * std::cos(t) + b * std::sin(t)}, .v = {b * std::cos(t) - a * std::sin(t)}, .z = {}};
  };
  return scene;
}

/// The conical pendulum H06: radius 0.8175 at the speed 3.27, hence 4 rad/s; depth 0.613125 = g/16. Tension per length
/// k (1 - L0/L) = 100 (1 - 0.858375/1.021875) = 16 = m 4^2, which carries m g as well: 16 * 0.613125 = 9.81.
inline Model conicalPendulumModel() {
  Model model;
  model.nodes = {{.x = Vec3::Zero(), .pinned = true},
                 {.x = Vec3(0.8175, 0.0, -0.613125), .v = Vec3(0.0, 3.27, 0.0), .m = 1.0}};
  model.springs = {{.a = 0, .b = 1, .k = 100.0, .L0 = 0.858375}};
  model.gravity = Vec3(0.0, 0.0, -9.81);
  return model;
}

inline ExactScene conicalPendulum() {
  ExactScene scene;
  scene.system = build(conicalPendulumModel());
  scene.start = scene.system->initialState();
  scene.exact = [](double t) {
    const double c = std::cos(4.0 * t), s = std::sin(4.0 * t);
    return State{.t = t, .x = {0.8175 * c, 0.8175 * s, -0.613125}, .v = {-3.27 * s, 3.27 * c, 0.0}, .z = {}};
  };
  return scene;
}

/// H06's spring from another start: it swings, stretches and turns.
inline Model elasticPendulumModel() {
  Model model = conicalPendulumModel();
  model.nodes[1].x = Vec3(0.9, 0.1, -0.5);
  model.nodes[1].v = Vec3(0.3, 2.0, 0.4);
  return model;
}

/// H08: three masses joined by three springs, flying freely.
inline Model freeTriangleModel() {
  Model model;
  model.nodes = {{.x = Vec3(0.0, 0.0, 0.0), .v = Vec3(0.5, 0.0, 1.0), .m = 1.0},
                 {.x = Vec3(1.2, 0.0, 0.0), .v = Vec3(-0.3, 0.8, 0.0), .m = 2.0},
                 {.x = Vec3(0.4, 0.9, 0.1), .v = Vec3(0.0, -0.5, 0.2), .m = 3.0}};
  model.springs = {{.a = 0, .b = 1, .k = 100.0, .L0 = 1.0},
                   {.a = 1, .b = 2, .k = 200.0, .L0 = 1.0},
                   {.a = 2, .b = 0, .k = 150.0, .L0 = 1.0}};
  return model;
}

/// Takes `steps` equal steps and looks at each state; every step must be done.
template <typename Look>
State run(Integrator& method, const DynamicalSystem& system, State state, double h, long long steps, Look look) {
  method.prepare(system, {});
  State next = state;
  for (long long n = 0; n < steps; ++n) {
    const StepResult result = method.step(system, state, h, next);
    if (!result.done) {
      ADD_FAILURE() << method.info().name << ", step " << n << ": " << result.failure;
      return state;
    }
    method.accept();
    std::swap(state, next);
    look(state);
  }
  return state;
}

inline State run(Integrator& method, const DynamicalSystem& system, State state, double h, long long steps) {
  return run(method, system, std::move(state), h, steps, [](const State&) {});
}

/// Every method of the catalogue, as a parameter of tests.
class EveryMethod : public ::testing::TestWithParam<std::string> {};

inline auto methodName() {
  return [](const ::testing::TestParamInfo<std::string>& instance) { return instance.param; };
}

}  // namespace muelle::engine::testing
