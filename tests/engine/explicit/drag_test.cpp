/// \file
/// Node drag in the methods that integrate it exactly, and damping in those that evaluate it.

#include "engine/integrators/explicit/methods.h"
#include "support/linear_system.h"

#include <gtest/gtest.h>
#include <cmath>

namespace muelle::engine {
namespace {

using testing::LinearSystem;
using Make = std::unique_ptr<Integrator> (*)();

State run(Make make, const DynamicalSystem& system, State state, double h, int steps) {
  const auto method = make();
  method->prepare(system, {});
  State next;
  for (int n = 0; n < steps; ++n) {
    EXPECT_TRUE(method->step(system, state, h, next).done);
    method->accept();
    std::swap(state, next);
  }
  return state;
}

// H23: k = 1, m = 1, d = 1e4, x = 0, v = 1; the closed form at t = 1.
TEST(Drag, IsExactInVelocityVerletHoweverStiff) {
  const LinearSystem system(1.0, 1e4);
  const State end = run(velocityVerlet, system, {.t = 0.0, .x = {0.0}, .v = {1.0}, .z = {}}, 1.0 / 60.0, 60);
  EXPECT_NEAR(end.x[0] / 9.99900024996834137392e-5, 1.0, 1e-3);
  EXPECT_NEAR(end.v[0] / -9.9990003499583458734e-9, 1.0, 1e-3);
}

// A constant force F: v -> F/d as 1 - exp(-d t/m), exactly at every step size.
TEST(Drag, WithAConstantForceIsSolvedExactly) {
  class Falling : public LinearSystem {
   public:
    Falling() : LinearSystem(0.0, 3.0) {}
    void accelerationWithoutDrag(double, In, In, In, Out a) const override { a[0] = 6.0; }
  };
  const Falling system;
  for (const int steps : {1, 7, 100, 1000}) {
    const State end = run(velocityVerlet, system, {.t = 0.0, .x = {0.5}, .v = {-1.0}, .z = {}}, 2.0 / steps, steps);
    const double decay = std::exp(-6.0);
    EXPECT_NEAR(end.v[0], 2.0 - 3.0 * decay, 1e-14 * std::sqrt(steps));
    EXPECT_NEAR(end.x[0], 0.5 + 2.0 * 2.0 - 3.0 * (1.0 - decay) / 3.0, 1e-14 * std::sqrt(steps));
  }
}

// The slow manifold x' = -k x / d of a strongly damped spring, from a start far from it and far beyond the step that
// could follow the decay: h d/m = 100, h k/d = 0.01.
TEST(Drag, KeepsTheSlowManifold) {
  const LinearSystem system(100.0, 1e3 * 10.0);
  const double h = 1e-2, slow = 1e4 / 1e4;
  const State end = run(velocityVerlet, system, {.t = 0.0, .x = {1.0}, .v = {0.0}, .z = {}}, h, 100);
  EXPECT_NEAR(end.x[0], std::exp(-slow), 0.01 * std::exp(-slow));  // first order in h k/d: 0.01/2
  EXPECT_NEAR(end.v[0], -slow * end.x[0], 1e-3 * end.x[0]);
}

/// Exact solution of x'' = -omega^2 x - d x', underdamped.
State damped(double omega, double d, const State& start, double t) {
  const double rate = d / 2.0, w = std::sqrt(omega * omega - rate * rate), decay = std::exp(-rate * t);
  const double a = start.x[0], b = (start.v[0] + rate * a) / w, c = std::cos(w * t), s = std::sin(w * t);
  const double x = decay * (a * c + b * s);
  return {.t = t, .x = {x}, .v = {decay * w * (b * c - a * s) - rate * x}, .z = {}};
}

double order(Make make, const DynamicalSystem& system, const State& start, const State& end, int steps) {
  const auto error = [&](int n) {
    const State found = run(make, system, start, end.t / n, n);
    return std::hypot(found.x[0] - end.x[0], found.v[0] - end.v[0]);
  };
  return std::log2(error(steps) / error(2 * steps));
}

TEST(Drag, KeepsTheOrderOfVerletAndOfTheCompositions) {
  const LinearSystem system(2.0, 0.6);
  const State start{.t = 0.0, .x = {1.0}, .v = {0.5}, .z = {}}, end = damped(2.0, 0.6, start, 3.0);
  EXPECT_NEAR(order(velocityVerlet, system, start, end, 100), 2.0, 0.05);
  EXPECT_NEAR(order(yoshida4, system, start, end, 60), 4.0, 0.1);
  EXPECT_NEAR(order(kahanLi8, system, start, end, 8), 8.0, 0.5);
}

/// The oscillator with its damping as any other velocity-dependent force.
class Damped : public LinearSystem {
 public:
  using LinearSystem::LinearSystem;
  const Drag* drag() const override { return nullptr; }
};

TEST(Drag, AsAnyOtherForceLeavesOrder2ToVerletAnd3ToTheCompositions) {
  const Damped system(2.0, 0.6);
  const State start{.t = 0.0, .x = {1.0}, .v = {0.5}, .z = {}}, end = damped(2.0, 0.6, start, 3.0);
  EXPECT_NEAR(order(velocityVerlet, system, start, end, 100), 2.0, 0.05);
  EXPECT_NEAR(order(yoshida4, system, start, end, 60), 3.0, 0.15);
  EXPECT_NEAR(order(kahanLi8, system, start, end, 60), 3.0, 0.15);
}

/// Two oscillators with drags and stiffnesses of their own, coupled by a spring that is not linear.
class TwoDrags : public LinearSystem {
 public:
  TwoDrags()
      : LinearSystem(Eigen::VectorXd::Ones(2), Eigen::MatrixXd::Identity(2, 2),
                     Eigen::Vector2d(0.3, 1.1).asDiagonal().toDenseMatrix()) {}
  void force(double t, In x, In v, In z, Out f) const override {
    accelerationWithoutDrag(t, x, v, z, f);
    f[0] -= 0.3 * v[0];
    f[1] -= 1.1 * v[1];
  }
  void accelerationWithoutDrag(double t, In x, In, In, Out a) const override {
    const double pull = std::sin(2.0 * (x[1] - x[0])) + 0.2 * std::cos(t);
    a[0] = -2.0 * x[0] + pull;
    a[1] = -5.0 * x[1] - pull;
  }
};

// Their order holds with lanes of different drag, against DOP853 at a fiftieth of their steps.
TEST(Drag, KeepsTheOrderOfTheNystroemMethods) {
  const TwoDrags system;
  State start{.t = 0.0, .x = {0.8, -0.4}, .v = {0.5, 1.0}, .z = {}};
  const double T = 3.0;
  const State end = run(dop853, system, start, T / 400, 400);
  struct Case {
    Make make;
    int steps;
    double order;
  };
  for (const Case& c : {Case{rkn64, 12, 6.0}, Case{nystrom8, 8, 8.0}, Case{nystrom12, 3, 12.0}}) {
    const auto error = [&](int n) {
      const State found = run(c.make, system, start, T / n, n);
      return std::hypot(found.x[0] - end.x[0], found.x[1] - end.x[1], found.v[0] - end.v[0]);
    };
    const double coarse = error(c.steps), fine = error(2 * c.steps);
    EXPECT_GT(std::log2(coarse / fine), c.order - 0.6) << c.make()->info().name << ' ' << coarse << ' ' << fine;
  }
}

// Where no force acts the step is exact whatever its length: v -> v exp(-c t), x -> x + v (1 - exp(-c t)) / c.
TEST(Drag, OfAFreeNodeIsExactInTheNystroemMethods) {
  const LinearSystem system(0.0, 3.0);
  for (const Make make : {rkn64, nystrom8, nystrom12}) {
    for (const int steps : {1, 7}) {
      const State end = run(make, system, {.t = 0.0, .x = {0.5}, .v = {-1.0}, .z = {}}, 2.0 / steps, steps);
      EXPECT_NEAR(end.v[0], -std::exp(-6.0), 1.2e-16 * steps) << make()->info().name;
      EXPECT_NEAR(end.x[0], 0.5 + std::expm1(-6.0) / 3.0, 1e-16 * steps) << make()->info().name;
    }
  }
}

// With drag as without: the force kept from the step before changes nothing, and the counts are those stated.
TEST(Drag, NystroemMethodsReuseTheForceAtTheEnd) {
  const TwoDrags system;
  for (const Make make : {rkn64, nystrom8, nystrom12}) {
    const auto kept = make(), fresh = make();
    kept->prepare(system, {});
    fresh->prepare(system, {});
    State a{.t = 0.0, .x = {0.8, -0.4}, .v = {0.5, 1.0}, .z = {}}, b = a, next, inside;
    for (int n = 0; n < 6; ++n) {
      if (n == 1) kept->resetWork();
      kept->step(system, a, 0.1, next);
      kept->accept();
      std::swap(a, next);
      fresh->restart();
      fresh->step(system, b, 0.1, next);
      std::swap(b, next);
    }
    EXPECT_EQ(kept->work().forceEvaluations, 5 * kept->info().stages) << kept->info().name;
    EXPECT_EQ(a.x, b.x);
    EXPECT_EQ(a.v, b.v);
    kept->step(system, a, 0.2, next);
    kept->interpolate(system, a, next, 0.5, inside);
    fresh->restart();
    fresh->step(system, a, 0.1, b);
    EXPECT_NEAR(inside.x[0], b.x[0], 1e-15);
    EXPECT_NEAR(inside.v[1], b.v[1], 1e-15);
  }
}

// Of a stiff, weakly damped oscillator: the spectral radius is that of the stiffness, h rho = 50 times its margin 1.2.
TEST(Drag, ChebyshevSeesTheStiffnessToo) {
  const LinearSystem system(1000.0, 10.0);
  const auto method = rungeKuttaChebyshev2();
  method->prepare(system, {});
  State to;
  for (int n = 0; n < 2; ++n) {
    method->resetWork();
    ASSERT_TRUE(method->step(system, {.t = 0.05 * n, .x = {1.0}, .v = {0.0}, .z = {}}, 0.05, to).done);
  }
  // A start and an end besides the stages; 1 + sqrt(1.54 * 60 + 1) = 10.7 of them.
  EXPECT_GE(method->work().forceEvaluations, 10);
  EXPECT_LE(method->work().forceEvaluations, 12);
}

TEST(Drag, ChebyshevTakesTheStagesThatItNeeds) {
  const LinearSystem system(1.0, 1e4);
  const auto method = rungeKuttaChebyshev2();
  method->prepare(system, {});
  State to;
  // h rho = 167: the root of 1.54 * 1.2 * 167, and one.
  ASSERT_TRUE(method->step(system, {.t = 0.0, .x = {0.0}, .v = {1.0}, .z = {}}, 1.0 / 60.0, to).done);
  EXPECT_GT(method->work().forceEvaluations, 17);
  EXPECT_LT(method->work().forceEvaluations, 40);
  const StepResult tooLong = method->step(system, {.t = 0.0, .x = {0.0}, .v = {1.0}, .z = {}}, 1e4, to);
  EXPECT_FALSE(tooLong.done);
  EXPECT_NE(tooLong.failure.find("stages"), std::string::npos) << tooLong.failure;
}

}  // namespace
}  // namespace muelle::engine
