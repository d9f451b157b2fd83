#include "engine/integrators/implicit/methods.h"
#include "run.h"
#include "support/spring_network.h"

#include <cmath>

namespace muelle::engine {
namespace {

using testing::run;
using testing::SpringNetwork;
using testing::start;
using Vector = Eigen::VectorXd;

/// Reference case H04, regular: one mass on a spring, in the plane (x, z).
SpringNetwork pendulum() { return {2, {1.0}, {{.k = 100.0, .L0 = 1.0}}, Vector{{0.0, -9.81}}}; }
State pendulumStart() { return start({0.3, -1.0}); }

double error(const State& a, double x, double z) { return std::hypot(a.x[0] - x, a.x[1] - z); }

TEST(Order, IsReachedOnTheElasticPendulum) {
  const SpringNetwork system = pendulum();
  for (const auto make : {backwardEuler, linearisedBackwardEuler, bdf2, trBdf2, implicitMidpoint, discreteGradient}) {
    const auto method = make();
    double errors[2];
    for (int i = 0; i < 2; ++i) {
      const int steps = 2000 << i;
      const State end = run(system, *method, pendulumStart(), 1.0 / steps, steps);
      errors[i] = error(end, -3.26606324962098120287e-1, -1.07972184036408539459e+0);
    }
    EXPECT_NEAR(std::log2(errors[0] / errors[1]), method->info().order, 0.05) << method->info().id;
  }
}

/// A chain of five nodes that swings from the horizontal, with dampers. The reference is esdirk4, whose error at this
/// step is a thousandth of TR-BDF2's.
TEST(Order, OfTrBdf2IsTwoOnASwingingChain) {
  std::vector<SpringNetwork::Spring> springs = {{.k = 2000.0, .L0 = 0.2, .damping = 0.5}};
  for (int i = 1; i < 5; ++i) springs.push_back({.a = i - 1, .b = i, .k = 2000.0, .L0 = 0.2, .damping = 0.5});
  const SpringNetwork system(2, std::vector<double>(5, 0.1), springs, Vector{{0.0, -9.81}});
  const State from = start({0.2, 0.0, 0.4, 0.0, 0.6, 0.0, 0.8, 0.0, 1.0, 0.0});
  const auto end = [&](Integrator& method, int steps) { return run(system, method, from, 0.4 / steps, steps); };
  const State exact = end(*esdirk4(), 1600);
  double errors[2];
  for (int i = 0; i < 2; ++i) {
    const State found = end(*trBdf2(), 800 << i);
    errors[i] = 0.0;
    for (std::size_t j = 0; j < 10; ++j) errors[i] = std::max(errors[i], std::abs(found.x[j] - exact.x[j]));
  }
  EXPECT_NEAR(std::log2(errors[0] / errors[1]), 2.0, 0.05) << errors[0] << " " << errors[1];
}

TEST(Energy, IsKeptByTheDiscreteGradientToRoundOff) {
  const SpringNetwork system = pendulum();
  const auto method = discreteGradient();
  method->prepare(system, {});
  State state = pendulumStart(), next = state;
  const double E0 = system.totalEnergy(state);
  double worst = 0.0;
  for (int i = 0; i < 20000; ++i) {
    ASSERT_TRUE(method->step(system, state, 0.01, next).done);
    std::swap(state, next);
    worst = std::max(worst, std::abs(system.totalEnergy(state) - E0));
  }
  EXPECT_LT(worst, 1e-12 * std::abs(E0));
}

/// With damping the energy that goes is what the dampers take at the midpoint, to round-off.
TEST(Energy, LostByTheDiscreteGradientIsTheWorkOfTheDampers) {
  const SpringNetwork system(2, {1.0}, {{.k = 100.0, .L0 = 1.0, .damping = 2.0}}, Vector{{0.0, -9.81}});
  const auto method = discreteGradient();
  method->prepare(system, {});
  State state = start({0.3, -1.3}, {1.0, 0.5}), next = state;
  for (int i = 0; i < 200; ++i) {
    ASSERT_TRUE(method->step(system, state, 0.01, next).done);
    const double xm = 0.5 * (state.x[0] + next.x[0]), zm = 0.5 * (state.x[1] + next.x[1]);
    const double vm = (xm * 0.5 * (state.v[0] + next.v[0]) + zm * 0.5 * (state.v[1] + next.v[1])) / std::hypot(xm, zm);
    EXPECT_NEAR(system.totalEnergy(next) - system.totalEnergy(state), -0.01 * 2.0 * vm * vm, 1e-13);
    std::swap(state, next);
  }
}

/// A free dumbbell keeps its momentum; the methods that say so keep its angular momentum too.
TEST(Momentum, OfAFreeDumbbellIsKept) {
  const SpringNetwork system(2, {1.0, 2.0}, {{.a = 0, .b = 1, .k = 50.0, .L0 = 1.0}}, Vector::Zero(2));
  for (const auto make : {backwardEuler, linearisedBackwardEuler, bdf2, trBdf2, implicitMidpoint, discreteGradient}) {
    const auto method = make();
    const State from = start({0.0, 0.0, 1.2, 0.0}, {0.0, 1.0, 0.3, -0.5});
    const State to = run(system, *method, from, 0.01, 1000);
    const auto angular = [](const State& s) {
      return s.x[0] * s.v[1] - s.x[1] * s.v[0] + 2.0 * (s.x[2] * s.v[3] - s.x[3] * s.v[2]);
    };
    EXPECT_NEAR(to.v[0] + 2.0 * to.v[2], 0.6, 1e-12) << method->info().id;
    EXPECT_NEAR(to.v[1] + 2.0 * to.v[3], 0.0, 1e-12) << method->info().id;
    if (method->info().conservesAngularMomentum) {
      EXPECT_NEAR(angular(to), angular(from), 1e-12) << method->info().id;
    } else {
      EXPECT_GT(std::abs(angular(to) - angular(from)), 1e-10) << method->info().id;
    }
  }
}

/// Reference case H14: a node between two compressed springs, 1e-6 off the axis. The step's matrix is indefinite.
TEST(Buckling, BackwardEulerLeavesTheSaddleForTheRing) {
  const auto spring = [](double anchor, double k) {
    return SpringNetwork::Spring{.k = k, .L0 = 1.0, .anchor = {anchor, 0.0, 0.0}};
  };
  const SpringNetwork system(3, {1.0}, {spring(-0.8, 1e6), spring(0.8, 1e6)}, Vector::Zero(3));
  for (const auto make : {backwardEuler, linearisedBackwardEuler}) {
    const auto method = make();
    const State end = run(system, *method, start({0.0, 1e-6, 0.0}), 1.0 / 60.0, 600);
    EXPECT_NEAR(std::hypot(end.x[1], end.x[2]), 0.6, 1e-6) << method->info().id;
  }
}

/// Reference case H16: a corner-hung cloth of 10 x 10 nodes with projected damping. The values are those of backward
/// Euler itself, h = 1/60, solved in extended precision.
class Cloth : public ::testing::Test {
 protected:
  static SpringNetwork cloth(double k) {
    std::vector<SpringNetwork::Spring> springs;
    const auto at = [](int i, int j) { return Eigen::Vector3d(0.1 * i, 0.1 * j, 0.0); };
    const auto free = [](int i, int j) {
      return 10 * j + i == 0 || 10 * j + i == 9 ? -1 : 10 * j + i - (j > 0 ? 2 : 1);
    };
    const auto join = [&](int i, int j, int p, int q) {
      if (p < 0 || p > 9 || q > 9) return;
      SpringNetwork::Spring s{
          .a = free(i, j), .b = free(p, q), .k = k, .L0 = (at(i, j) - at(p, q)).norm(), .damping = 0.01};
      if (s.a < 0 && s.b < 0) return;
      s.anchor = at(p, q);
      if (s.a < 0) {
        s.a = s.b;
        s.b = -1;
        s.anchor = at(i, j);
      }
      springs.push_back(s);
    };
    for (int j = 0; j < 10; ++j) {
      for (int i = 0; i < 10; ++i) {
        join(i, j, i + 1, j);
        join(i, j, i, j + 1);
        join(i, j, i + 1, j + 1);
        join(i, j, i - 1, j + 1);
      }
    }
    return {3, std::vector<double>(98, 0.001), springs, Vector{{0.0, 0.0, -9.81}}};
  }
  static State flat() {
    std::vector<double> x;
    for (int j = 0; j < 10; ++j) {
      for (int i = 0; i < 10; ++i) {
        if (j == 0 && (i == 0 || i == 9)) continue;
        x.insert(x.end(), {0.1 * i, 0.1 * j, 0.0});
      }
    }
    return start(x);
  }
};

TEST_F(Cloth, ConvergedBackwardEulerHitsTheDiscreteReference) {
  const SpringNetwork system = cloth(1000.0);
  const auto method = backwardEuler();
  const State half = run(system, *method, flat(), 1.0 / 60.0, 30);
  EXPECT_NEAR(half.x[291], 0.89995722535318754, 1e-9);
  EXPECT_NEAR(half.x[292], -0.14495674885602108, 1e-9);
  EXPECT_NEAR(half.x[293], -0.87946488870011266, 1e-9);
  const State one = run(system, *method, half, 1.0 / 60.0, 30);
  EXPECT_NEAR(one.x[291], 0.90001430778996382, 1e-9);
  EXPECT_NEAR(one.x[292], -0.80092823889156483, 1e-9);
  EXPECT_NEAR(one.x[293], -0.34634910512331222, 1e-9);
}

TEST_F(Cloth, StaysSaneWithStiffSprings) {
  for (const double k : {1e5, 1e6}) {
    const SpringNetwork system = cloth(k);
    const State from = flat();
    const auto method = backwardEuler();
    const State end = run(system, *method, from, 1.0 / 60.0, 30);
    EXPECT_LT(system.totalEnergy(end), system.totalEnergy(from) + 1e-9) << k;
    EXPECT_LT(end.x[293], -0.5) << k;
  }
}

}  // namespace
}  // namespace muelle::engine
