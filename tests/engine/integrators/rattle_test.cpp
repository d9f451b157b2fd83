/// \file
/// Rods: RATTLE against the exact pendulum, its invariants, the limit of stiff springs, and what is refused.

#include "engine/control/simulate.h"
#include "engine/integrators/catalogue.h"
#include "engine/integrators/explicit/methods.h"
#include "engine/model/model_system.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace muelle::engine {
namespace {

constexpr double g = 9.81;

ModelNode nodeAt(const Vec3& x, const Vec3& v = Vec3::Zero(), double m = 1.0) {
  ModelNode node;
  node.x = x;
  node.v = v;
  node.m = m;
  return node;
}

ModelSpring rodBetween(const Model& model, int a, int b) {
  ModelSpring spring;
  spring.a = a;
  spring.b = b;
  spring.L0 = (model.nodes[static_cast<std::size_t>(a)].x - model.nodes[static_cast<std::size_t>(b)].x).norm();
  spring.rod = true;
  return spring;
}

/// A pin and `links` rods of 1 m in a row, at `angle` from the vertical, in the plane (x, z).
Model pendulumOfRods(int links, double angle) {
  Model model;
  model.dimension = 2;
  model.plane = {0, 2};
  model.gravity = Vec3(0, 0, -g);
  for (int i = 0; i <= links; ++i) model.nodes.push_back(nodeAt(i * Vec3(std::sin(angle), 0, -std::cos(angle))));
  model.nodes[0].pinned = true;
  for (int i = 0; i < links; ++i) model.springs.push_back(rodBetween(model, i, i + 1));
  return model;
}

RunOptions stepsOf(double h, double duration) {
  RunOptions options;
  options.h = h;
  options.duration = duration;
  options.checkStability = options.checkNumericalDamping = false;
  return options;
}

RunResult runRods(const ModelSystem& system, double h, double duration) {
  const auto method = rattle();
  RunResult result = simulate(system, *method, system.initialState(), stepsOf(h, duration));
  EXPECT_FALSE(result.failed()) << result.trajectory.stop.message;
  return result;
}

/// Complete elliptic integral K(k) by the arithmetic-geometric mean.
double ellipticK(double k) {
  double a = 1.0, b = std::sqrt(1.0 - k * k);
  for (int i = 0; i < 40; ++i) {
    const double mean = 0.5 * (a + b);
    b = std::sqrt(a * b);
    a = mean;
  }
  return std::numbers::pi / (2.0 * a);
}

/// T = 4 K(sin(angle / 2)) sqrt(L / g). After one period the pendulum is back; the error of order 2 is in the phase,
/// at the turning point of second order in itself, so a quarter of a period later it is looked at: x = 0 there.
TEST(Rattle, PendulumHasTheExactPeriod) {
  const double angle = 1.5, T = 4.0 * ellipticK(std::sin(0.5 * angle)) / std::sqrt(g);
  const auto system = build(pendulumOfRods(1, angle));
  double errors[2];
  for (int i = 0; i < 2; ++i) {
    const RunResult result = runRods(*system, 1.25 * T / (4000 << i), 1.25 * T);
    errors[i] = std::abs(system->position(result.last, 1)[0]);
    EXPECT_NEAR(system->position(result.last, 1).norm(), 1.0, 1e-14);
  }
  EXPECT_LT(errors[1], 1e-5);
  EXPECT_NEAR(std::log2(errors[0] / errors[1]), 2.0, 0.05) << errors[0] << " " << errors[1];
}

/// A double pendulum, chaotic, over 100 s: lengths and rates to round-off, energy in a band that does not widen.
TEST(Rattle, DoublePendulumKeepsItsEnergyInABand) {
  const auto system = build(pendulumOfRods(2, 2.0));
  const RunResult result = runRods(*system, 1e-3, 100.0);
  const Trajectory& path = result.trajectory;
  State state = system->initialState();
  const double E0 = system->totalEnergy(state);
  double early = 0.0, late = 0.0;
  for (std::size_t i = 0; i < path.t.size(); ++i) {
    state.x = path.x[i];
    state.v = path.v[i];
    double& worst = path.t[i] < 20.0 ? early : late;
    worst = std::max(worst, std::abs(system->totalEnergy(state) - E0));
    const Vec3 d = system->position(state, 2) - system->position(state, 1);
    ASSERT_NEAR(d.norm(), 1.0, 1e-13);
    // Speeds are up to 8 m/s: some of their last bits.
    ASSERT_NEAR(d.dot(system->velocity(state, 2) - system->velocity(state, 1)), 0.0, 1e-12);
  }
  // (h omega)^2 / 8 of the energy that swings, some 40 J, at up to 10 rad/s: 5e-4 J.
  EXPECT_LT(early, 2e-3);
  EXPECT_LT(late, 3.0 * early);
}

/// Two nodes on a rod, free in space, and a third on a spring: momentum and angular momentum to round-off of 1e4 steps.
TEST(Rattle, FreePairKeepsMomentumAndAngularMomentum) {
  Model model;
  model.nodes = {nodeAt(Vec3(0, 0, 0), Vec3(0.5, 1.0, -0.3), 1.0), nodeAt(Vec3(1, 0, 0), Vec3(0.5, -1.0, 0.7), 2.0),
                 nodeAt(Vec3(1, 1, 0.5), Vec3(0, 0, 0.2), 0.5)};
  model.springs = {rodBetween(model, 0, 1), {.a = 1, .b = 2, .k = 30.0, .L0 = 1.0}};
  const auto system = build(model);
  const State start = system->initialState();
  const RunResult result = runRods(*system, 1e-3, 10.0);
  EXPECT_LT((system->momentum(result.last) - system->momentum(start)).norm(), 1e-11);
  EXPECT_LT((system->angularMomentum(result.last) - system->angularMomentum(start)).norm(), 1e-10);
  EXPECT_NEAR((system->position(result.last, 1) - system->position(result.last, 0)).norm(), 1.0, 1e-13);
}

/// The pendulum on a spring, released at rest at its rest length, oscillates by m g / k along the spring about the
/// stretched pendulum, with omega = sqrt(k / m): so the largest differences over a second are of size 1/k in positions
/// and 1/sqrt(k) in velocities. A hundredfold k: 100 and 10 times, each with a share of order 1/sqrt(k) of the next.
TEST(Rattle, IsTheLimitOfStiffSprings) {
  const double angle = 1.0, h = 5e-5, duration = 1.0;
  const auto rod = build(pendulumOfRods(1, angle));
  const RunResult exact = runRods(*rod, h, duration);
  double dx[2], dv[2];
  for (int i = 0; i < 2; ++i) {
    Model model = pendulumOfRods(1, angle);
    model.springs[0].rod = false;
    model.springs[0].k = i == 0 ? 1e4 : 1e6;  // h omega <= 0.05
    const auto spring = build(model);
    const auto method = makeMethod("yoshida4");
    const RunResult result = simulate(*spring, *method, spring->initialState(), stepsOf(h, duration));
    dx[i] = dv[i] = 0.0;
    for (std::size_t s = 0; s < result.trajectory.t.size(); ++s) {
      for (std::size_t c = 0; c < 2; ++c) {
        dx[i] = std::max(dx[i], std::abs(result.trajectory.x[s][c] - exact.trajectory.x[s][c]));
        dv[i] = std::max(dv[i], std::abs(result.trajectory.v[s][c] - exact.trajectory.v[s][c]));
      }
    }
  }
  EXPECT_NEAR(dx[0] / dx[1], 100.0, 20.0) << dx[0] << " " << dx[1];
  EXPECT_NEAR(dv[0] / dv[1], 10.0, 2.0) << dv[0] << " " << dv[1];
  EXPECT_LT(dx[1], 1e-4);
}

std::string refusalOf(const Model& model) {
  try {
    build(model);
  } catch (const std::invalid_argument& refusal) {
    return refusal.what();
  }
  return "";
}

/// A square with both diagonals in the plane: six rods for the five inner freedoms of four nodes.
TEST(Rods, RedundantOnesAreNamed) {
  Model model;
  model.dimension = 2;
  model.plane = {0, 2};
  for (const Vec3& x : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 0, 1), Vec3(0, 0, 1)}) model.nodes.push_back(nodeAt(x));
  for (const auto& [a, b] : {std::pair(0, 1), std::pair(1, 2), std::pair(2, 3), std::pair(3, 0), std::pair(0, 2)}) {
    model.springs.push_back(rodBetween(model, a, b));
  }
  EXPECT_EQ(refusalOf(model), "");
  model.springs.push_back(rodBetween(model, 1, 3));
  EXPECT_NE(refusalOf(model).find("spring 5 (nodes 1 and 3): redundant rod"), std::string::npos) << refusalOf(model);

  Model pins = pendulumOfRods(2, 0.3);
  pins.nodes.push_back(nodeAt(Vec3(5, 0, 0)));
  pins.nodes[3].pinned = true;
  pins.springs.push_back(rodBetween(pins, 0, 3));
  EXPECT_NE(refusalOf(pins).find("spring 2 (nodes 0 and 3): redundant rod"), std::string::npos) << refusalOf(pins);
}

TEST(Rods, ThatStartStretchedStretchingDampedOrMovedAreRefused) {
  Model model = pendulumOfRods(1, 0.3);
  model.springs[0].L0 = 1.1;
  EXPECT_NE(refusalOf(model).find("spring 0: a rod of 1.1 m"), std::string::npos) << refusalOf(model);
  model = pendulumOfRods(1, 0.0);
  model.nodes[1].v = Vec3(1, 0, 0.5);
  EXPECT_NE(refusalOf(model).find("cannot stretch"), std::string::npos) << refusalOf(model);
  model = pendulumOfRods(1, 0.0);
  model.springs[0].dProjected = 0.1;
  EXPECT_NE(refusalOf(model).find("damped"), std::string::npos) << refusalOf(model);
  model = pendulumOfRods(1, 0.0);
  model.nodes[0].pinned = false;
  model.nodes[0].motion = 0;
  model.motions.push_back({[](double, int) { return Vec3(0, 0, 0); }, [](double, int) { return Vec3(0, 0, 0); }});
  EXPECT_NE(refusalOf(model).find("node 0, which is moved"), std::string::npos) << refusalOf(model);
}

TEST(Rods, EveryOtherMethodRefusesThemNamingRattle) {
  const auto system = build(pendulumOfRods(1, 0.3));
  for (const std::string& id : methodIds()) {
    if (id == "rattle") continue;
    const auto method = makeMethod(id);
    try {
      simulate(*system, *method, system->initialState(), stepsOf(0.01, 0.1));
      ADD_FAILURE() << id;
    } catch (const std::invalid_argument& refusal) {
      const std::string text = refusal.what();
      EXPECT_NE(text.find("'rattle'"), std::string::npos) << text;
      EXPECT_NE(text.find(id), std::string::npos) << text;
    }
  }
  Model damped = pendulumOfRods(1, 0.3);
  damped.nodes[1].drag = 0.1;
  const auto dragged = build(damped);
  EXPECT_THROW(simulate(*dragged, *rattle(), dragged->initialState(), stepsOf(0.01, 0.1)), std::invalid_argument);
}

/// The rods turn by more than half a turn in this step.
TEST(Rattle, AStepThatIsTooLongIsNotDone) {
  Model model = pendulumOfRods(1, 0.0);
  model.nodes[1].v = Vec3(100, 0, 0);
  const auto system = build(model);
  const auto method = rattle();
  method->prepare(*system, {});
  const State from = system->initialState();
  State to = from;
  const StepResult result = method->step(*system, from, 0.1, to);
  EXPECT_FALSE(result.done);
  EXPECT_NE(result.failure.find("turn too far"), std::string::npos) << result.failure;
}

}  // namespace
}  // namespace muelle::engine
