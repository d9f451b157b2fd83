/// \file
/// What MethodInfo says about stability, measured on the methods themselves.

#include "engine/integrators/explicit/methods.h"
#include "support/linear_system.h"

#include <gtest/gtest.h>
#include <cmath>
#include <functional>

namespace muelle::engine {
namespace {

using testing::LinearSystem;
using Make = std::unique_ptr<Integrator> (*)();

/// Matrix of one step on (omega x, v), column by column.
struct StepMatrix {
  double xx, xv, vx, vv;
  double trace() const { return xx + vv; }
  double determinant() const { return xx * vv - xv * vx; }
  double spectralRadius() const {
    const double half = 0.5 * trace(), discriminant = half * half - determinant();
    return discriminant < 0.0 ? std::sqrt(determinant()) : std::abs(half) + std::sqrt(discriminant);
  }
};

StepMatrix stepMatrix(Make make, double omega, double damping) {
  const LinearSystem system(omega, damping);
  const auto column = [&](double x, double v) {
    const auto method = make();
    method->prepare(system, {});
    State to;
    EXPECT_TRUE(method->step(system, {.t = 0.0, .x = {x}, .v = {v}, .z = {}}, 1.0, to).done);
    return to;
  };
  const State first = column(1.0 / omega, 0.0), second = column(0.0, 1.0);
  return {omega * first.x[0], omega * second.x[0], first.v[0], second.v[0]};
}

/// Largest y below `beyond` up to which (in steps of 1e-3) the step does not amplify, refined by bisection.
double limit(const std::function<bool(double)>& isStable, double beyond) {
  double y = 1e-3;
  while (y < beyond && isStable(y)) y += 1e-3;
  double low = y - 1e-3, high = y;
  for (int i = 0; i < 40; ++i) (isStable(0.5 * (low + high)) ? low : high) = 0.5 * (low + high);
  return low;
}

class UndampedLimit : public ::testing::TestWithParam<Make> {};

// H03's table by the amplification of the method itself. Round-off of one step, 1e-13, is not growth; the first
// unstable interval of DOP853 and of the compositions is entered at an angle, which costs the digits left out.
TEST_P(UndampedLimit, IsTheOneStated) {
  const MethodInfo info = GetParam()()->info();
  const double found =
      limit([](double y) { return stepMatrix(GetParam(), y, 0.0).spectralRadius() <= 1.0 + 1e-12; }, 9.0);
  EXPECT_NEAR(found, info.imaginaryLimit, 1e-6 * info.imaginaryLimit + 2e-3 * (info.imaginaryLimit == 0.0))
      << info.name;
}

INSTANTIATE_TEST_SUITE_P(Explicit, UndampedLimit,
                         ::testing::Values(explicitEuler, symplecticEuler, velocityVerlet, rungeKutta4, dormandPrince5,
                                           dop853, nystrom8, nystrom12, yoshida4, kahanLi8),
                         [](const auto& instance) { return instance.param()->info().id; });

// |R(iy)|^2 = 1 + y^4/4: growth that is below round-off for small y (H03: 9.5e-7 with a resolution of 1e-24).
TEST(Stability, ExplicitMidpointGrowsByAQuarterOfTheFourthPower) {
  EXPECT_NEAR(stepMatrix(explicitMidpoint, 0.1, 0.0).determinant() - 1.0, 0.25e-4, 1e-15);
  EXPECT_EQ(explicitMidpoint()->info().stability, Stability::Never);
}

// On x' = v, v' = -d v with k = 0 the velocity is multiplied by R(-h d).
double velocityFactor(Make make, double damping) {
  const LinearSystem system(0.0, damping);
  const auto method = make();
  method->prepare(system, {});
  State to;
  EXPECT_TRUE(method->step(system, {.t = 0.0, .x = {0.0}, .v = {1.0}, .z = {}}, 1.0, to).done);
  return to.v[0];
}

TEST(Stability, RealLimitIsTheOneStated) {
  for (const Make make : {explicitEuler, symplecticEuler, explicitMidpoint, rungeKutta4, dormandPrince5, dop853}) {
    const MethodInfo info = make()->info();
    const double found = limit([make](double y) { return std::abs(velocityFactor(make, y)) <= 1.0 + 1e-13; }, 9.0);
    EXPECT_NEAR(found, info.realLimit, 1e-9 * info.realLimit) << info.name;
  }
}

// The number of stages follows the drag: the velocity is damped at any step.
TEST(Stability, ChebyshevDampsWhateverTheDrag) {
  for (const double damping : {1.0, 10.0, 1e3, 1e5}) {
    EXPECT_LT(std::abs(velocityFactor(rungeKuttaChebyshev2, damping)), 1.0) << damping;
  }
}

// Without drag the limit is h omega = 2; drag only widens it. (By the Jury conditions on the step's matrix; at
// h omega = 2 they hold with equality for d = 0.)
TEST(Stability, DragDoesNotLowerTheLimitOfVelocityVerlet) {
  for (double drag = 0.01; drag < 1e6; drag *= 1.5) {
    EXPECT_LT(stepMatrix(velocityVerlet, 1.999, drag).spectralRadius(), 1.0) << drag;
  }
}

// A damping that is no node drag: (D not diagonal) the force at a predicted velocity gives R(-h d) = 1 - y + y^2/2.
TEST(Stability, VerletWithSpringDampingIsStableToTwo) {
  Eigen::MatrixXd D(2, 2);
  D << 1.0, -1.0, -1.0, 1.0;  // eigenvalue 2 of the relative velocity
  const auto factor = [&](double y) {
    const LinearSystem system(Eigen::VectorXd::Ones(2), Eigen::MatrixXd::Zero(2, 2), 0.5 * y * D);
    const auto method = velocityVerlet();
    method->prepare(system, {});
    State to;
    EXPECT_TRUE(method->step(system, {.t = 0.0, .x = {0.0, 0.0}, .v = {0.5, -0.5}, .z = {}}, 1.0, to).done);
    return to.v[0] - to.v[1];
  };
  for (const double y : {0.1, 1.0, 1.9, 2.5}) EXPECT_NEAR(factor(y), 1.0 - y + 0.5 * y * y, 1e-14) << y;
  EXPECT_EQ(velocityVerlet()->info().realLimit, 2.0);
}

}  // namespace
}  // namespace muelle::engine
