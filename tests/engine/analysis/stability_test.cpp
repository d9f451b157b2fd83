#include "engine/analysis/stability.h"
#include "engine/solve/dense.h"

#include "engine/analysis/amplification.h"
#include "engine/analysis/numerical_damping.h"
#include "engine/integrators/catalogue.h"
#include "support/linear_system.h"

#include <gtest/gtest.h>
#include <cmath>
#include <numbers>

namespace muelle::engine {
namespace {

using testing::LinearSystem;
using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

State restOf(int n) {
  const auto size = static_cast<std::size_t>(n);
  return {0.0, std::vector<double>(size, 0.0), std::vector<double>(size, 0.0), {}};
}

/// Two masses of 1 kg: a spring of 1e6 N/m to the wall and one of 1 N/m between them.
LinearSystem stiffAndSoft() {
  Matrix K = Matrix::Zero(2, 2);
  K << 1e6 + 1.0, -1.0, -1.0, 1.0;
  return {Vector::Ones(2), K, Matrix::Zero(2, 2)};
}

double imaginaryLimit(const char* id) {
  const auto method = makeMethod(id);
  return Amplification(*method).imaginaryLimit();
}

TEST(Amplification, LimitsOnTheImaginaryAxisAreThoseOfTheTable) {
  // Hard case H03, from the stability functions and the traces of the compositions; the bar is 1 %.
  EXPECT_NEAR(imaginaryLimit("velocity_verlet"), 2.0, 1e-6);
  EXPECT_NEAR(imaginaryLimit("symplectic_euler"), 2.0, 1e-6);
  EXPECT_NEAR(imaginaryLimit("runge_kutta_4"), 2.8284271247461900976, 1e-6);
  EXPECT_NEAR(imaginaryLimit("dormand_prince_5"), 0.997189008632529915523, 1e-6);
  EXPECT_NEAR(imaginaryLimit("yoshida4"), 1.57340194743454005663, 1e-6);
  EXPECT_NEAR(imaginaryLimit("kahan_li_8"), 3.09643868000073217261, 1e-6);
  EXPECT_EQ(imaginaryLimit("explicit_euler"), 0.0);
  EXPECT_EQ(imaginaryLimit("explicit_midpoint"), 0.0);
  for (const char* id : {"backward_euler", "bdf2", "tr_bdf2", "esdirk4", "implicit_midpoint", "discrete_gradient"}) {
    EXPECT_TRUE(std::isinf(imaginaryLimit(id))) << id;
  }
}

TEST(Amplification, LimitsOnTheRealAxisAreThoseOfTheTable) {
  const auto limit = [](const char* id) {
    const auto method = makeMethod(id);
    return Amplification(*method).realLimit();
  };
  // Where R = 1, the position's eigenvalue 1 makes a double one, and rounding its root.
  constexpr double tolerance = 1e-5;
  EXPECT_NEAR(limit("explicit_euler"), 2.0, tolerance);
  EXPECT_NEAR(limit("explicit_midpoint"), 2.0, tolerance);
  EXPECT_NEAR(limit("runge_kutta_4"), 2.78529356340528162353, tolerance);
  EXPECT_NEAR(limit("dormand_prince_5"), 3.30656789263494650372, tolerance);
  EXPECT_TRUE(std::isinf(limit("backward_euler")));
}

TEST(Amplification, TheFactsOfEveryMethodAgreeWithWhatItDoes) {
  for (const std::string& id : methodIds()) {
    const auto method = makeMethod(id);
    const double measured = Amplification(*method).imaginaryLimit();
    const double stated = method->info().imaginaryLimit;
    if (std::isinf(stated)) {
      EXPECT_TRUE(std::isinf(measured)) << id << " " << measured;
    } else {
      // Growth of the eighth power shows only beyond h omega = 0.3.
      EXPECT_NEAR(measured, stated, id == "rkn64" ? 0.5 : 0.01 * stated) << id;
    }
  }
}

TEST(Amplification, DecayOfAMethodWithMemoryIsThatOfItsCharacteristicEquation) {
  // BDF2 on x' = i z x: (3/2 - i z) r^2 - 2 r + 1/2 = 0.
  const double z = 1.0;
  const std::complex<double> a(1.5, -z), root = std::sqrt(4.0 - 2.0 * a);
  const double exact = std::max(std::abs((2.0 + root) / (2.0 * a)), std::abs((2.0 - root) / (2.0 * a)));
  const auto method = makeMethod("bdf2");
  EXPECT_NEAR(Amplification(*method).growth(z * z, 0.0), exact, 2e-3);
  const auto euler = makeMethod("backward_euler");
  EXPECT_NEAR(Amplification(*euler).growth(z * z, 0.0), 1.0 / std::sqrt(1.0 + z * z), 1e-10);
}

double largestStep(const DynamicalSystem& system, const char* id) {
  const auto method = makeMethod(id);
  return stability(system, *method, restOf(system.size())).largestStep;
}

TEST(Stability, TheLimitOfTheStiffnessRatioIsThatOfItsFastMode) {
  // Hard case H11: springs of 1e6 and 1 N/m.
  const LinearSystem system = stiffAndSoft();
  EXPECT_NEAR(largestStep(system, "velocity_verlet"), 0.00199999899999975000088, 1e-9);
  EXPECT_NEAR(largestStep(system, "symplectic_euler"), 0.00199999899999975000088, 1e-9);
  EXPECT_TRUE(std::isinf(largestStep(system, "backward_euler")));
  EXPECT_EQ(largestStep(system, "explicit_euler"), 0.0);
}

TEST(Stability, StiffDragLimitsExplicitEuler) {
  // Hard case H23: explicit Euler 2 m / d (to 1e-8 relative: k h / d); relative damping of a pair: m / d.
  const LinearSystem drag(1.0, 1e4);
  EXPECT_NEAR(largestStep(drag, "explicit_euler"), 2e-4, 2e-10);
  Matrix K(2, 2);
  K << 1.0, -1.0, -1.0, 1.0;
  const LinearSystem pair(Vector::Ones(2), K, 1e4 * K);
  EXPECT_NEAR(largestStep(pair, "explicit_euler"), 1e-4, 1e-8);
  // Symplectic Euler with lagged damping: h^2 k/m + 2 h d/m = 4 with k -> 2 k, d -> 2 d for the pair.
  const double h = largestStep(pair, "symplectic_euler");
  EXPECT_NEAR(h * h * 2.0 + 2.0 * h * 2e4, 4.0, 1e-4);
}

TEST(Stability, DampedOscillatorsFollowTheirClosedForms) {
  // Explicit Euler on x'' = -w^2 x - c v, underdamped: h = c / w^2.
  EXPECT_NEAR(largestStep(LinearSystem(10.0, 2.0), "explicit_euler"), 0.02, 1e-7);
  EXPECT_NEAR(largestStep(LinearSystem(10.0, 0.002), "explicit_euler"), 2e-5, 2e-8)
      << "growth counts from 1e-11 a step on, which c dh / 2 reaches 1e-8 s beyond the limit";
  // Overdamped (H02, d = 200): 2 / lambda_fast, lambda_fast = 100 + sqrt(9900).
  EXPECT_NEAR(largestStep(LinearSystem(10.0, 200.0), "explicit_euler"), 2.0 / (100.0 + std::sqrt(9900.0)), 1e-8);
}

/// A chain of n masses between two walls: omega_max = 2 sqrt(k/m) sin(n pi / (2 (n + 1))).
Matrix chain(int n, double k) {
  Matrix K = Matrix::Zero(n, n);
  for (int i = 0; i < n; ++i) K(i, i) = 2.0 * k;
  for (int i = 0; i + 1 < n; ++i) K(i, i + 1) = K(i + 1, i) = -k;
  return K;
}

TEST(Stability, ALongChainHasTheLimitOfItsClosedForm) {
  for (const int n : {5, 50, 400}) {
    const LinearSystem system(Vector::Constant(n, 0.5), chain(n, 100.0), Matrix::Zero(n, n));
    const double w = 2.0 * std::sqrt(200.0) * std::sin(n * std::numbers::pi / (2.0 * (n + 1)));
    const double h = largestStep(system, "velocity_verlet");
    EXPECT_NEAR(h, 2.0 / w, 5e-3 * 2.0 / w) << n;
  }
}

/// The spectral radius of a method's step on a linear system, column by column.
double stepRadius(Integrator& method, const LinearSystem& system, double h) {
  const int n = system.size();
  method.prepare(system, {});
  Matrix map(2 * n, 2 * n);
  for (int j = 0; j < 2 * n; ++j) {
    State from = restOf(n);
    (j < n ? from.x : from.v)[static_cast<std::size_t>(j % n)] = 1.0;
    State to = from;
    method.restart();
    method.step(system, from, h, to);
    for (int i = 0; i < n; ++i) {
      map(i, j) = to.x[static_cast<std::size_t>(i)];
      map(n + i, j) = to.v[static_cast<std::size_t>(i)];
    }
  }
  return spectralRadius(map);
}

TEST(Stability, CoupledStiffnessAndDampingAgreeWithTheEigenvaluesOfTheStep) {
  // K and D do not commute: stiff where there is little damping, and the other way round.
  const int n = 12;
  Matrix K = chain(n, 100.0), D = chain(n, 0.5);
  K.topLeftCorner(3, 3) *= 20.0;
  D.bottomRightCorner(4, 4) *= 30.0;
  const LinearSystem system(Vector::LinSpaced(n, 0.5, 2.0), 0.5 * (K + K.transpose()), 0.5 * (D + D.transpose()));
  for (const char* id : {"explicit_euler", "explicit_midpoint", "runge_kutta_4", "dormand_prince_5", "symplectic_euler",
                         "velocity_verlet"}) {
    const auto method = makeMethod(id);
    const StabilityReport report = stability(system, *method, restOf(n));
    ASSERT_TRUE(std::isfinite(report.largestStep)) << id;
    double low = 0.2 * report.largestStep, high = 3.0 * report.largestStep;
    for (int k = 0; k < 40; ++k) {
      const double middle = 0.5 * (low + high);
      (stepRadius(*method, system, middle) <= 1.0 + 1e-10 ? low : high) = middle;
    }
    const bool partitioned = std::string(id) == "symplectic_euler" || std::string(id) == "velocity_verlet";
    EXPECT_NEAR(report.largestStep, low, (partitioned ? 0.05 : 1e-4) * low) << report.sentence;
  }
}

TEST(Stability, TheSentenceNamesMethodLimitAndUnknown) {
  const LinearSystem system = stiffAndSoft();
  const auto method = makeMethod("velocity_verlet");
  const StabilityReport report = stability(system, *method, restOf(2));
  EXPECT_EQ(report.sentence,
            "velocity Verlet is stable here up to h = 0.002 s; a mode at unknown 0 (omega = 1000 /s, 159 Hz) sets the "
            "limit");
}

/// The same physics without matrices.
class Bare : public LinearSystem {
 public:
  using LinearSystem::LinearSystem;
  const Linearisation* linearisation() const override { return nullptr; }
};

TEST(Stability, WithoutALinearisationDifferencesOfTheForceDo) {
  const int n = 30;
  const Matrix K = chain(n, 100.0);
  const LinearSystem system(Vector::Ones(n), K, 0.01 * K);
  const Bare bare(Vector::Ones(n), K, 0.01 * K);
  EXPECT_NEAR(largestStep(bare, "runge_kutta_4"), largestStep(system, "runge_kutta_4"), 1e-6);
}

TEST(NumericalDamping, BackwardEulerOnAFastModeIsToldAndTheSceneIsMeasured) {
  const LinearSystem system(40.0, 1.0);  // h omega = 0.67 at 1/60 s; own decay 0.5 /s
  State start = restOf(1);
  start.x[0] = 1.0;
  const auto method = makeMethod("backward_euler");
  const NumericalDamping report = numericalDamping(system, *method, start, 1.0 / 60.0, 2.0);
  ASSERT_TRUE(report.exceeds);
  const double z = 40.0 / 60.0;
  EXPECT_NEAR(report.frequency, 40.0, 1e-6);
  EXPECT_NEAR(report.numericalDecay, 60.0 * 0.5 * std::log1p(z * z), 1e-6) << "1/sqrt(1 + z^2) a step";
  EXPECT_NEAR(report.ownDecay, 0.5, 1e-9);
  EXPECT_NE(report.sentence.find("numerical damping exceeds yours"), std::string::npos);
}

TEST(NumericalDamping, SilentWhereTheStepIsFineOrTheSceneIsMoreDampedOrTheMethodConserves) {
  State start = restOf(1);
  start.x[0] = 1.0;
  const auto euler = makeMethod("backward_euler");
  EXPECT_FALSE(numericalDamping(LinearSystem(10.0, 0.0), *euler, start, 1.0 / 60.0, 2.0).exceeds) << "h omega = 0.17";
  EXPECT_FALSE(numericalDamping(LinearSystem(40.0, 60.0), *euler, start, 1.0 / 60.0, 2.0).exceeds) << "own decay 30";
  const auto midpoint = makeMethod("implicit_midpoint");
  EXPECT_FALSE(numericalDamping(LinearSystem(40.0, 0.0), *midpoint, start, 1.0 / 60.0, 2.0).exceeds);
}

TEST(NumericalDamping, AFastModeWithoutEnergyIsNoReasonToWarn) {
  // Two oscillators of 1 and 100 /s, of which only the slow one moves.
  const LinearSystem system(Vector::Ones(2), Vector{{1.0, 1e4}}.asDiagonal(), Matrix::Zero(2, 2));
  State start = restOf(2);
  start.x[0] = 1.0;
  const auto method = makeMethod("backward_euler");
  EXPECT_FALSE(numericalDamping(system, *method, start, 1.0 / 60.0, 10.0).exceeds);
  start.v[1] = 2.0;
  EXPECT_TRUE(numericalDamping(system, *method, start, 1.0 / 60.0, 10.0).exceeds);
}

}  // namespace
}  // namespace muelle::engine
