/// \file
/// What MethodInfo says about stability, measured on the methods themselves.

#include "engine/integrators/explicit/methods.h"
#include "engine/solve/dense.h"
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

/// The growth a step of a damped, sprung pair's relative motion, from the last of many steps: velocity Verlet with a
/// damping that is no node drag (D not diagonal), of the relative motion's h omega = y and h d/m = z.
double verletGrowth(double y, double z) {
  Eigen::MatrixXd pair(2, 2);
  pair << 0.5, -0.5, -0.5, 0.5;  // eigenvalue 1 of the relative motion
  const LinearSystem system(Eigen::VectorXd::Ones(2), y * y * pair, z * pair);
  const auto method = velocityVerlet();
  method->prepare(system, {});
  State state{.t = 0.0, .x = {0.5, -0.5}, .v = {0.3, -0.3}, .z = {}}, next;
  double early = 0.0, late = 0.0;
  constexpr int steps = 4000;
  for (int n = 1; n <= steps; ++n) {
    if (!method->step(system, state, 1.0, next).done) return HUGE_VAL;
    method->accept();
    std::swap(state, next);
    // The size in the units of the velocity: without a spring the place stays where it is.
    const double size = std::hypot(y * (state.x[0] - state.x[1]), state.v[0] - state.v[1]);
    if (n > steps / 4 && n <= steps / 2) early = std::max(early, size);
    if (n > 3 * steps / 4) late = std::max(late, size);
  }
  if (early < 1e-280) return 0.0;
  return std::pow(late / early, 2.0 / steps);
}

// (v, h a) goes by a matrix of trace 1 - 3z/2 and determinant -z/2, in the unit circle up to z = 1 (VelocityVerlet).
// The growth a step beyond is 4/3 of the excess: the growth that 4000 steps show, 1e-6, is 1e-6 of the limit.
TEST(Stability, VerletWithSpringDampingIsStableToOne) {
  const double found = limit([](double z) { return verletGrowth(0.0, z) <= 1.0 + 1e-6; }, 3.0);
  EXPECT_NEAR(found, 1.0, 2e-5);
  EXPECT_EQ(velocityVerlet()->info().realLimit, 1.0);
}

// With a spring of h omega = y besides, the characteristic polynomial of (x, v, h a) is that of the recursion
// x+ = x + h v + h^2/2 a, v+ = v + h/2 (a + a+), a+ = -y^2 x+ - z (v + a): the limit by its eigenvalues.
TEST(Stability, VerletWithSpringAndDampingFollowsItsMatrix) {
  for (const double zeta : {0.05, 0.2, 0.5}) {
    const auto radius = [&](double y) {
      const double z = 2.0 * zeta * y;
      Eigen::MatrixXd M(3, 3);
      // clang-format off
      M << 1.0, 1.0, 0.5,
           -0.5 * y * y, 1.0 - 0.5 * (y * y + z), 0.5 - 0.25 * y * y - 0.5 * z,
           -y * y, -y * y - z, -0.5 * y * y - z;
      // clang-format on
      return spectralRadius(M);
    };
    const double stated = limit([&](double y) { return radius(y) <= 1.0 + 1e-6; }, 3.0);
    const double found = limit([&](double y) { return verletGrowth(y, 2.0 * zeta * y) <= 1.0 + 1e-6; }, 3.0);
    EXPECT_NEAR(found, stated, 1e-3 * stated) << zeta;
    EXPECT_LE(2.0 * zeta * stated, 1.0 + 1e-3) << zeta;
  }
}

// The map inside is velocity Verlet of the frequency omega sqrt(1 - (h omega)^2/12), stable as long as that is real: it
// is never above 2/h. The states outside follow it by a matrix that stays regular up to there.
TEST(Stability, TakahashiImadaIsStableToTwoRootsOfThree) {
  const auto grows = [](double y) {
    const LinearSystem system(y, 0.0);
    const auto method = takahashiImada();
    method->prepare(system, {});
    State state{.t = 0.0, .x = {1.0}, .v = {0.0}, .z = {}}, next;
    double largest = 0.0;
    for (int n = 0; n < 3000; ++n) {
      if (!method->step(system, state, 1.0, next).done) return true;
      method->accept();
      std::swap(state, next);
      largest = std::max(largest, std::abs(state.x[0]));
    }
    // Inside the limit the amplitude is at most 1/sqrt(1 - y^2/12) and more times the start; beyond it grows without
    // end.
    return largest > 1e4;
  };
  double low = 3.0, high = 4.0;
  for (int i = 0; i < 30; ++i) {
    const double middle = 0.5 * (low + high);
    (grows(middle) ? high : low) = middle;
  }
  // 3000 steps of growth sqrt(2 y dy / 6)... make 1e4 of 1 from an excess of about 1e-5.
  EXPECT_NEAR(low, takahashiImada()->info().imaginaryLimit, 1e-4);
}

// A mode without damping grows by 1e-7 (h omega)^8 a step, unseen at small steps: no limit can be stated.
TEST(Stability, RungeKuttaNystroem6GrowsByTheEighthPower) {
  EXPECT_NEAR(std::log2((stepMatrix(rkn64, 1.0, 0.0).spectralRadius() - 1.0) /
                        (stepMatrix(rkn64, 0.5, 0.0).spectralRadius() - 1.0)),
              8.0, 0.3);
  EXPECT_NEAR(stepMatrix(rkn64, 1.0, 0.0).spectralRadius() - 1.0, 1.0038303410730975e-07, 1e-14);
  EXPECT_EQ(rkn64()->info().stability, Stability::Never);
}

}  // namespace
}  // namespace muelle::engine
