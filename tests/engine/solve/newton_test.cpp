#include "engine/solve/newton.h"

#include "support/linear_system.h"

#include <gtest/gtest.h>
#include <cmath>
#include <limits>

namespace muelle::engine {
namespace {

using testing::LinearSystem;
using Vector = Eigen::VectorXd;

/// w = F with F = 1, of which the matrix knows nothing: with k = 1 it is 2 where the residual's slope is 1, so that a
/// step along it goes half of the way, which is poor, and GMRES is asked. \param gap  F is not finite for 0 < |w| < gap
ImplicitStage halfWaySteps(double gap) {
  ImplicitStage stage;
  stage.tau = stage.alpha = stage.beta = 1.0;
  stage.X0 = Vector::Ones(1);
  stage.V0 = Vector::Zero(1);
  stage.force = [gap](const Vector& w, const Vector&, const Vector&, Vector& F) {
    const bool near = w[0] != 0.0 && std::abs(w[0]) < gap;
    F[0] = near ? std::numeric_limits<double>::quiet_NaN() : 1.0;
  };
  return stage;
}

// GMRES takes its differences 1.5e-8 from the start; in the gap it has none to go by.
TEST(Newton, KeepsThePointThatItsSearchAcceptedWhereGmresFails) {
  const LinearSystem system(1.0, 0.0);
  for (const double gap : {0.0, 1e-6}) {
    Newton newton;
    newton.prepare(system);
    Vector w = Vector::Zero(1);
    Work work;
    const ImplicitStage stage = halfWaySteps(gap);
    const NewtonReport report = newton.solve(system, stage, {}, w, work);
    EXPECT_TRUE(report.done) << gap << " " << report.failure;
    EXPECT_NEAR(w[0], 1.0, 1e-12) << gap;
    EXPECT_LE(report.iterations, gap == 0.0 ? 2 : 4) << gap;
  }
}

}  // namespace
}  // namespace muelle::engine
