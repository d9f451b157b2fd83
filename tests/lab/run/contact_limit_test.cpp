/// \file
/// The stability limit told before a run counts the contacts that may close. It is held against the step at which a
/// node that is pressed at rest, and perturbed, begins to grow, found by bisection.

#include "engine/analysis/stability.h"
#include "engine/control/simulate.h"
#include "engine/integrators/catalogue.h"
#include "engine/model/model_system.h"
#include "engine/statics/equilibrium.h"

#include <gtest/gtest.h>
#include <cmath>
#include <functional>

namespace muelle::lab {

using namespace engine;
namespace {

constexpr double g = 9.81;

Model ball(double k, double d) {
  Model model;
  model.gravity = Vec3(0.0, 0.0, -g);
  model.nodes.push_back({.x = Vec3(0.0, 0.0, 1.0), .m = 0.5});
  Obstacle ground;
  ground.material.k = k;
  ground.material.d = d;
  model.obstacles.push_back(ground);
  return model;
}

/// The same model with its lowest node in the ground, as deep as the ground carries all.
Model pressed(Model model) {
  double mass = 0.0;
  std::size_t lowest = 0;
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    mass += model.nodes[i].m;
    if (model.nodes[i].x[2] < model.nodes[lowest].x[2]) lowest = i;
  }
  const double shift = model.nodes[lowest].x[2] + mass * g / model.obstacles[0].material.k;
  for (ModelNode& node : model.nodes) node.x[2] -= shift;
  return model;
}

/// Whether a perturbation of 1e-10 m, at which the ground does not let go, grows a hundredfold over 4000 steps.
bool grows(const Model& model, const char* id, double h) {
  const std::unique_ptr<ModelSystem> system = build(model);
  const std::unique_ptr<Integrator> method = makeMethod(id);
  RunOptions options;
  options.h = h;
  options.fixedStep = true;
  options.duration = 4000.0 * h;
  options.locateEvents = options.checkStability = options.checkNumericalDamping = options.keepStates = false;
  const State rest = system->initialState();
  State start = rest;
  for (std::size_t i = 2; i < start.x.size(); i += 3)
    start.x[i] += i % 2 == 0 ? 1e-10 : -1e-10;  // along z: a column would buckle
  const RunResult result = simulate(*system, *method, start, options);
  if (result.failed()) return true;
  double off = 0.0;
  for (std::size_t i = 0; i < rest.x.size(); ++i) {
    if (i % 3 == 2) off = std::max(off, std::abs(result.last.x[i] - rest.x[i]));
  }
  return off > 1e-8;
}

double trueLimit(const Model& atRest, const char* id, double guess) {
  double stable = 0.5 * guess, unstable = 2.0 * guess;
  EXPECT_FALSE(grows(atRest, id, stable));
  EXPECT_TRUE(grows(atRest, id, unstable));
  while (unstable - stable > 1e-3 * stable) {
    const double middle = 0.5 * (stable + unstable);
    (grows(atRest, id, middle) ? unstable : stable) = middle;
  }
  return stable;
}

/// \param far  the model before anything touches
void expectTold(const Model& far, const char* id) {
  const std::unique_ptr<ModelSystem> system = build(far);
  const std::unique_ptr<Integrator> method = makeMethod(id);
  const double told = stability(*system, *method, system->initialState()).largestStep;
  const double limit = trueLimit(pressed(far), id, told);
  EXPECT_LE(told, 1.002 * limit)
      << id;  // bisection to 1e-3; within 2e-4 of its limit a stable run swings a hundredfold, too
  EXPECT_GE(told, 0.9 * limit) << id;
}

TEST(LimitWithContacts, OfABallIsThatOfItsBounce) {
  for (const char* id : {"velocity_verlet", "symplectic_euler", "runge_kutta_4"}) expectTold(ball(1e5, 0.0), id);
}

TEST(LimitWithContacts, CountsTheDamperOfTheGround) {
  // Critical damping is 2 sqrt(k m) = 447 kg/s.
  for (const double d : {50.0, 2000.0}) {
    for (const char* id : {"velocity_verlet", "symplectic_euler", "runge_kutta_4"}) expectTold(ball(1e5, d), id);
  }
}

TEST(LimitWithContacts, CountsTheSpringsOfTheNodeThatTouches) {
  Model model = ball(1e4, 0.0);
  model.nodes.push_back({.x = Vec3(0.0, 0.0, 1.5), .m = 0.5});
  model.springs.push_back({.a = 0, .b = 1, .k = 2e4, .L0 = 0.5});
  // At rest the upper one sinks by m g / k.
  model.nodes[1].x[2] -= 0.5 * g / 2e4;
  for (const char* id : {"velocity_verlet", "symplectic_euler"}) expectTold(model, id);
}

}  // namespace
}  // namespace muelle::lab
