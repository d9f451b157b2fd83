/// \file
/// What a single step owes its caller: the same result with and without reuse of forces, an interpolant of its order,
/// an error estimate that follows the error, a report instead of numbers that are not finite, and no allocation.

#include "engine/integrators/explicit/methods.h"
#include "support/allocation_count.h"
#include "support/linear_system.h"

#include <gtest/gtest.h>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace muelle::engine {
namespace {

using testing::LinearSystem;
using Make = std::unique_ptr<Integrator> (*)();

constexpr Make all[] = {explicitEuler,
                        symplecticEuler,
                        explicitMidpoint,
                        velocityVerlet,
                        takahashiImada,
                        rungeKutta4,
                        dormandPrince5,
                        dop853,
                        rkn64,
                        nystrom8,
                        nystrom12,
                        yoshida4,
                        kahanLi8,
                        rungeKuttaChebyshev2};

/// A plane elastic pendulum of mass 1, stiffness 20, rest length 1, with a force in time: smooth and not linear.
class Pendulum : public DynamicalSystem {
 public:
  int size() const override { return 2; }
  std::span<const double> mass() const override { return mass_; }
  bool forceUsesVelocity() const override { return false; }
  void force(double t, In x, In, In, Out f) const override {
    ++calls;
    const double stretch = 20.0 * (1.0 - 1.0 / std::hypot(x[0], x[1]));
    f[0] = -stretch * x[0] + 0.5 * std::cos(1.3 * t);
    f[1] = -stretch * x[1] - 9.81;
  }
  mutable long long calls = 0;

 private:
  std::array<double, 2> mass_{1.0, 1.0};
};

const State start{.t = 0.2, .x = {1.1, -0.3}, .v = {0.4, 0.7}, .z = {}};

double distance(const State& a, const State& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.x.size(); ++i) {
    largest = std::max({largest, std::abs(a.x[i] - b.x[i]), std::abs(a.v[i] - b.v[i])});
  }
  return largest;
}

/// The exact state after `duration`, by steps of order 12 that are far below round-off.
State exact(const DynamicalSystem& system, State state, double duration) {
  const auto method = nystrom12();
  method->prepare(system, {});
  const int steps = 1 + static_cast<int>(duration / 0.02);
  for (int n = 0; n < steps; ++n) {
    State next;
    method->step(system, state, duration / steps, next);
    std::swap(state, next);
  }
  return state;
}

bool isChebyshev(Make make) { return make == static_cast<Make>(rungeKuttaChebyshev2); }

class Every : public ::testing::TestWithParam<Make> {};
INSTANTIATE_TEST_SUITE_P(Explicit, Every, ::testing::ValuesIn(all),
                         [](const auto& instance) { return instance.param()->info().id; });

TEST_P(Every, ReuseOfAForceChangesNothing) {
  const Pendulum system;
  const auto withMemory = GetParam()(), without = GetParam()();
  withMemory->prepare(system, {});
  without->prepare(system, {});
  State a = start, b = start, next, trial;
  for (int n = 0; n < 20; ++n) {
    // A rejected step in between leaves no memory.
    withMemory->step(system, a, 0.03, trial);
    if (n % 4 == 0) withMemory->interpolate(system, a, trial, 0.4, next);
    ASSERT_TRUE(withMemory->step(system, a, 0.01, next).done);
    withMemory->accept();
    if (n % 5 == 0) withMemory->interpolate(system, a, next, 0.6, trial);
    std::swap(a, next);
    without->restart();
    ASSERT_TRUE(without->step(system, b, 0.01, next).done);
    without->accept();
    std::swap(b, next);
  }
  if (isChebyshev(GetParam())) {
    EXPECT_LT(distance(a, b), 1e-6);  // restart() estimates the spectral radius anew: another number of stages
  } else {
    EXPECT_EQ(distance(a, b), 0.0);
  }
}

// After restart(), and from a state that is not the one accepted, the force is evaluated anew.
TEST_P(Every, GoesOnFromTheStateThatItIsGiven) {
  const Pendulum system;
  const auto used = GetParam()(), fresh = GetParam()();
  used->prepare(system, {});
  fresh->prepare(system, {});
  State to, other, expected;
  used->step(system, start, 0.01, to);
  used->accept();
  State moved = to;
  moved.x[1] += 0.1;
  used->step(system, moved, 0.01, other);
  fresh->step(system, moved, 0.01, expected);
  const double tolerance = isChebyshev(GetParam()) ? 1e-6 : 0.0;
  EXPECT_LE(distance(other, expected), tolerance);
}

TEST_P(Every, CountsItsForceEvaluations) {
  const Pendulum system;
  const auto method = GetParam()();
  method->prepare(system, {});
  State state = start, next;
  for (int n = 0; n < 10; ++n) {
    method->step(system, state, 0.01, next);
    method->accept();
    method->interpolate(system, state, next, 0.3, state);
    std::swap(state, next);
  }
  EXPECT_EQ(method->work().forceEvaluations, system.calls);
}

// After the first step an accepted step costs what MethodInfo says.
TEST_P(Every, CostsTheStagesStated) {
  const Pendulum system;
  const auto method = GetParam()();
  method->prepare(system, {});
  State state = start, next;
  for (int n = 0; n < 11; ++n) {
    if (n == 1) method->resetWork();
    method->step(system, state, 0.01, next);
    method->accept();
    std::swap(state, next);
  }
  // RKC2: the stages stated are the fewest; one more is that the spectral radius is looked at.
  const long long spectral = isChebyshev(GetParam()) ? 1 : 0;
  EXPECT_EQ(method->work().forceEvaluations, 10 * method->info().stages + spectral);
}

// A step that is taken again keeps the force at its start, where the method has stages after it.
TEST(Reuse, ARejectedStepCostsOneForceLess) {
  const Pendulum system;
  for (const Make make : {rungeKutta4, dop853, rkn64, nystrom8, nystrom12}) {
    const auto method = make();
    method->prepare(system, {});
    State to;
    method->step(system, start, 0.02, to);
    const long long first = method->work().forceEvaluations;
    method->step(system, start, 0.01, to);
    EXPECT_EQ(method->work().forceEvaluations, 2 * first - 1) << method->info().name;
  }
}

TEST_P(Every, DoesNotAllocateInAStep) {
  const Pendulum system;
  const auto method = GetParam()();
  method->prepare(system, {});
  State state = start, next;
  method->step(system, state, 0.01, next);
  method->accept();
  std::swap(state, next);
  method->step(system, state, 0.01, next);  // the other of the two states has its size now
  const long before = allocationCount();
  for (int n = 0; n < 100; ++n) {
    method->step(system, state, 0.01, next);
    method->accept();
    std::swap(state, next);
  }
  EXPECT_EQ(allocationCount(), before);
}

TEST_P(Every, ReportsAForceThatIsNotFinite) {
  class Broken : public Pendulum {
   public:
    void force(double t, In x, In v, In z, Out f) const override {
      Pendulum::force(t, x, v, z, f);
      f[1] = std::numeric_limits<double>::quiet_NaN();
    }
    std::string unknownName(int i) const override { return i == 0 ? "node 0, x" : "node 0, y"; }
  };
  const Broken system;
  const auto method = GetParam()();
  method->prepare(system, {});
  State to;
  const StepResult result = method->step(system, start, 0.01, to);
  EXPECT_FALSE(result.done);
  EXPECT_NE(result.failure.find("node 0, "), std::string::npos) << result.failure;
}

// x and v change by the increment to the last digit of the state, and by more digits than the state holds.
TEST_P(Every, IncrementsAreTheChangeOfTheState) {
  const Pendulum system;
  const auto method = GetParam()();
  method->prepare(system, {});
  State to, increment;
  method->step(system, start, 1e-3, to);
  method->restart();
  method->stepIncrement(system, start, 1e-3, increment);
  for (int i = 0; i < 2; ++i) {
    EXPECT_NEAR(start.x[i] + increment.x[i], to.x[i], 4e-16);
    EXPECT_NEAR(start.v[i] + increment.v[i], to.v[i], 4e-16);
  }
}

// Hermite, quintic for positions: its error is that of the method, or h^4 in velocities.
TEST_P(Every, InterpolatesAtItsOrder) {
  const Pendulum system;
  const auto method = GetParam()();
  method->prepare(system, {});
  const auto error = [&](double h) {
    State to, inside;
    method->restart();
    method->step(system, start, h, to);
    double largest = 0.0;
    for (const double theta : {0.2, 0.5, 0.7, 0.95}) {
      method->interpolate(system, start, to, theta, inside);
      EXPECT_NEAR(inside.t, start.t + theta * h, 1e-15);
      largest = std::max(largest, distance(inside, exact(system, start, theta * h)));
    }
    return largest;
  };
  const int order = method->info().order;
  const std::string id = method->info().id;
  const double h = order > 8 ? 0.4 : order == 8 ? 0.1 : 0.02;
  // The local error of the step is of order p + 1, of a dense output of order q, q + 1; Hermite's cubic has q = 3.
  const int expected = id == "dormand_prince_5" ? 5
                       : id == "dop853"         ? 8
                       : order > 4              ? order + 1
                                                : std::min(order + 1, 4);
  const double measured = std::log2(error(h) / error(h / 2.0));
  // DOP853's interpolant shows its order only below h = 0.05, in round-off; OrderConditions has it exactly.
  EXPECT_GT(measured, expected - (id == "dop853" ? 0.75 : 0.25)) << error(h) << ' ' << error(h / 2.0);
  State to, end, begin;
  method->restart();
  method->step(system, start, h, to);
  method->interpolate(system, start, to, 0.0, begin);
  method->interpolate(system, start, to, 1.0, end);
  EXPECT_LT(distance(begin, start), 1e-15);
  // A part of 1 of the step is another h by its rounding, to which weights are rounded anew: those of nystrom12, up to
  // 300, half a unit in the last place each, as many at random, in stages that enter with h^2 a times 0.2 (h omega)^2.
  EXPECT_LT(distance(end, to), order > 8 ? 2e-14 : 4e-15);
}

// The estimate is of the embedded order, and bounds the true local error where it is small. (That of a Chebyshev step
// is of h^3, and is told as its power 2/3: see stepTolerance().)
TEST(ErrorEstimate, FollowsTheErrorAndBoundsIt) {
  struct Case {
    Make make;
    double h;
    int power;  // of h, of the estimate
  };
  const Pendulum system;
  for (const Case& c : {Case{dormandPrince5, 0.05, 5}, Case{dop853, 0.1, 8}, Case{rkn64, 0.1, 5},
                        Case{nystrom8, 0.2, 7}, Case{nystrom12, 0.25, 11}, Case{rungeKuttaChebyshev2, 0.01, 2}}) {
    const auto method = c.make();
    EXPECT_TRUE(method->info().adaptive);
    method->prepare(system, {.relative = 1.0});
    State to;
    const auto estimate = [&](double h) {
      method->restart();
      return method->step(system, start, h, to).error;
    };
    const double coarse = estimate(c.h), fine = estimate(c.h / 2.0);
    EXPECT_NEAR(std::log2(coarse / fine), c.power, 0.5) << method->info().name;
    EXPECT_GT(fine, distance(to, exact(system, start, c.h / 2.0)) / 2.0) << method->info().name;
  }
}

// It is measured in parts of the motion's size, in units of the tolerance. What rounding alone may make of an estimate,
// 4 ulp of a state of size 1, adds 1e-15 to the 1e-6 that is allowed: 1e-9 of the ratio. A Chebyshev step's estimate
// may be 1e-9 at this tolerance, of which that is 1e-6, and is told as its power 2/3: see stepTolerance().
TEST(ErrorEstimate, IsInPartsOfTheMotionAndOfTheTolerance) {
  const Pendulum system;
  for (const Make make : {dormandPrince5, dop853, rkn64, nystrom8, nystrom12, rungeKuttaChebyshev2}) {
    const auto method = make();
    State to;
    const auto error = [&](double tolerance, const ErrorScale& scale) {
      method->measureErrorsBy(scale);
      method->prepare(system, {.relative = tolerance});
      return method->step(system, start, 0.1, to).error;
    };
    const bool isOwnError = make == Make(rungeKuttaChebyshev2);
    const double power = isOwnError ? 2.0 / 3.0 : 1.0, rounding = isOwnError ? 1e-6 : 1e-8;
    const double tighter = error(1e-6, {1.0, 1.0}) / error(1e-3, {1.0, 1.0});
    const double smaller = error(1e-6, {1.0, 1.0}) / error(1e-6, {1e3, 1e3});
    EXPECT_NEAR(tighter / 1e3, 1.0, rounding) << method->info().name;
    EXPECT_NEAR(smaller / std::pow(1e3, power), 1.0, rounding) << method->info().name;
    const double positions = error(1e-6, {1.0, HUGE_VAL}), velocities = error(1e-6, {HUGE_VAL, 1.0});
    EXPECT_GT(positions, 0.0) << method->info().name;
    EXPECT_GT(velocities, 0.0) << method->info().name;
  }
}

/// Damped as a spring is, not by drag.
class SpringDamped : public LinearSystem {
 public:
  SpringDamped() : LinearSystem(1.0, 0.1) {}
  const Drag* drag() const override { return nullptr; }
};

TEST(Nystrom, NeedsAForceWithoutVelocity) {
  const SpringDamped damped;
  for (const Make make : {rkn64, nystrom8, nystrom12, takahashiImada}) {
    EXPECT_TRUE(make()->info().needs.velocityFreeForce);
    try {
      make()->prepare(damped, {});
      ADD_FAILURE() << "no message";
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find("velocity"), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace muelle::engine
