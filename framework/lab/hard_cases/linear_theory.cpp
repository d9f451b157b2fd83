#include "lab/hard_cases/linear_theory.h"

#include "engine/analysis/test_oscillator.h"
#include "engine/integrators/catalogue.h"
#include "engine/solve/dense.h"
#include "lab/hard_cases/running.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <Eigen/LU>
#include <functional>
#include <limits>
#include <span>
#include <stdexcept>

namespace muelle::hard_cases {

namespace {

/// The power of a step's matrix to 1e5 steps would lose five of a double's digits.
using Real = long double;
using Block = Eigen::Matrix<Real, 2, 2>;
using Vector = Eigen::Matrix<Real, 2, 1>;
using Pair = Eigen::Matrix<Real, 4, 4>;  ///< of two states, one after the other

/// (x, v)' = L (x, v).
Block generator(const Mode& m) {
  Block L;
  L << 0.0, 1.0, -m.stiffness, -(m.damping + m.drag);
  return L;
}

/// The truncated exponential series of Z up to `order`.
Block series(const Block& Z, int order) {
  Block sum = Block::Identity();
  for (int j = order; j >= 1; --j) sum = Block::Identity() + Z * sum / j;
  return sum;
}

/// exp(Z) by scaling and squaring.
Block exponential(const Block& Z) {
  const int halvings = std::max(0, static_cast<int>(std::ceil(std::log2(Z.cwiseAbs().maxCoeff() + 1e-300L))) + 4);
  Block result = series(Z * std::ldexp(Real(1), -halvings), 17);
  for (int i = 0; i < halvings; ++i) result = result * result;
  return result;
}

/// The matrix of a linear map, column by column.
Block matrixOf(const std::function<Vector(Vector)>& map) {
  Block result;
  result << map(Vector(1, 0)), map(Vector(0, 1));
  return result;
}

/// What the drag does in a step: see engine::DragFactors.
struct DragFactors {
  Real decay, phi1, phi2;
  explicit DragFactors(Real c)
      : decay(std::exp(-c)),
        phi1(std::abs(c) < 1e-8L ? 1 - c / 2 : -std::expm1(-c) / c),
        phi2(std::abs(c) < 1e-4L ? Real(1) / 2 - c / 6 + c * c / 24 : (1 - phi1) / c) {}
};

/// Velocity Verlet with the drag exact and the damping at velocities of its own at both ends, as compositions take it
/// and as the first step does; h may be negative.
Block verlet(const Mode& m, Real h) {
  const DragFactors f(h * m.drag);
  return matrixOf([=](Vector y) -> Vector {
    const Real a0 = -m.stiffness * y[0] - m.damping * y[1];
    const Real x = y[0] + h * f.phi1 * y[1] + h * h * f.phi2 * a0;
    const Real predicted = f.decay * y[1] + h * f.phi1 * a0;
    const Real a1 = -m.stiffness * x - m.damping * predicted;
    return {x, f.decay * y[1] + h * ((f.phi1 - f.phi2) * a0 + f.phi2 * a1)};
  });
}

/// Takahashi-Imada: velocity Verlet of the stiffness k (1 - e k) on (q, p), x = (1 - e k) q and v = (1 + e k) p, with
/// e = h^2/12. At its limit nothing comes out of q; beyond, it grows.
Block takahashiImada(const Mode& m, Real h) {
  const Real e = h * h * m.stiffness / 12;
  Mode inside = m;
  inside.stiffness *= static_cast<double>(1 - e);
  Block out = Block::Zero();
  out(0, 0) = 1 - e;
  out(1, 1) = 1 + e;
  return out * verlet(inside, h) * out.inverse();
}

Block symplecticEuler(const Mode& m, Real h) {
  return matrixOf([=](Vector y) -> Vector {
    const Real v = y[1] + h * (-m.stiffness * y[0] - (m.damping + m.drag) * y[1]);
    return {y[0] + h * v, v};
  });
}

Block composed(const Mode& m, Real h, std::span<const Real> fractions) {
  Block result = Block::Identity();
  for (const Real fraction : fractions) result = verlet(m, fraction * h) * result;
  return result;
}

Block yoshida4(const Mode& m, Real h) {
  const Real w = 1 / (2 - std::cbrt(Real(2)));
  return composed(m, h, std::array{w, 1 - 2 * w, w});
}

/// Kahan and Li 1997, order 8 with 17 stages.
Block kahanLi8(const Mode& m, Real h) {
  constexpr Real g[] = {0.13020248308889008088L, 0.56116298177510838456L,  -0.38947496264484728641L,
                        0.15884190655515560090L, -0.39590389413323757734L, 0.18453964097831570709L,
                        0.25837438768632204729L, 0.29501172360931029887L,  -0.60550853383003451170L};
  std::array<Real, 17> all;
  for (std::size_t j = 0; j < 17; ++j) all[j] = g[j < 9 ? j : 16 - j];
  return composed(m, h, all);
}

Block backwardEuler(const Block& Z) { return (Block::Identity() - Z).inverse(); }
Block midpoint(const Block& Z) { return (Block::Identity() - Z / 2).inverse() * (Block::Identity() + Z / 2); }

template <class Square>
Square power(Square base, long long n) {
  Square result = Square::Identity(base.rows(), base.cols());
  for (; n > 0; n /= 2) {
    if (n % 2 == 1) result = base * result;
    base = base * base;
  }
  return result;
}

/// The eigenvalue of the largest magnitude, the one of positive angle of a pair; infinite when the matrix is not
/// finite.
template <class Square>
std::complex<double> leadingEigenvalue(const Square& M) {
  if (!M.allFinite()) return std::numeric_limits<double>::infinity();
  const engine::Eigenpairs pairs = engine::eigenpairs(M.template cast<double>());
  std::complex<double> leading = 0.0;
  for (const std::complex<double>& value : pairs.values) {
    if (std::abs(value) > std::abs(leading)) leading = value;
  }
  return {leading.real(), std::abs(leading.imag())};
}

/// Velocity Verlet with damping on (x, v, a, 0): the acceleration at a predicted velocity is the next step's first.
Pair predictedVerlet(const Mode& m, Real h) {
  const DragFactors f(h * m.drag);
  Pair step = Pair::Zero();
  for (int j = 0; j < 3; ++j) {
    const Real x = j == 0 ? 1 : 0, v = j == 1 ? 1 : 0, a = j == 2 ? 1 : 0;
    const Real end = x + h * f.phi1 * v + h * h * f.phi2 * a;
    const Real after = -m.stiffness * end - m.damping * (f.decay * v + h * f.phi1 * a);
    step(0, j) = end;
    step(1, j) = f.decay * v + h * ((f.phi1 - f.phi2) * a + f.phi2 * after);
    step(2, j) = after;
  }
  return step;
}

/// BDF2 on (y_n, y_{n-1}), the first step by Alexander's SDIRK of two stages.
struct TwoStep {
  Pair step;
  Block first;
};
TwoStep bdf2(const Block& Z) {
  const Block I = Block::Identity(), solve = (I - Z * 2 / 3).inverse();
  TwoStep result;
  result.step << solve * 4 / 3, -solve / 3, I, Block::Zero();
  const Real gamma = 1 - std::sqrt(Real(0.5));
  const Block stage = (I - gamma * Z).inverse();
  result.first = stage * (I + (1 - gamma) * Z * stage);
  return result;
}

/// The trapezoidal rule to gamma h, then BDF2 to h, gamma = 2 - sqrt(2): one matrix for both.
Block trBdf2(const Block& Z) {
  const Block I = Block::Identity();
  const Real gamma = 2 - std::sqrt(Real(2)), c = 1 / (gamma * (2 - gamma));
  const Block solve = (I - gamma / 2 * Z).inverse(), middle = solve * (I + gamma / 2 * Z);
  return solve * (c * middle - c * (1 - gamma) * (1 - gamma) * I);
}

std::optional<Block> stepMatrix(const std::string& id, const Mode& m, Real h) {
  const Block Z = h * generator(m);
  if (id == "explicit_euler") return series(Z, 1);
  if (id == "explicit_midpoint") return series(Z, 2);
  if (id == "runge_kutta_4") return series(Z, 4);
  if (id == "symplectic_euler") return symplecticEuler(m, h);
  if (id == "velocity_verlet" || id == "rattle") return verlet(m, h);
  if (id == "takahashi_imada" && m.damping == 0.0 && m.drag == 0.0) return takahashiImada(m, h);
  if (id == "yoshida4") return yoshida4(m, h);
  if (id == "kahan_li_8") return kahanLi8(m, h);
  if (id == "backward_euler" || id == "linearised_backward_euler" || id == "projective_dynamics") {
    return backwardEuler(Z);
  }
  if (id == "implicit_midpoint" || id == "discrete_gradient") return midpoint(Z);
  if (id == "tr_bdf2") return trBdf2(Z);
  if (id == "xpbd") return power(backwardEuler(Z / 20), 20);  // its substeps
  return std::nullopt;
}

/// Distance in the mode's plane [m]: velocities over omega.
double sizeOf(const Mode& mode, const Vector& y) {
  const double omega = std::sqrt(std::max(std::abs(mode.stiffness), 1e-300));
  return static_cast<double>(std::hypot(y[0], y[1] / omega));
}

Vector startOf(const Mode& mode) { return {mode.amplitude, mode.speed}; }
double durationOf(const Mode& mode, double run) { return mode.duration > 0.0 ? mode.duration : run; }

/// What the numbers at the end say.
ModeForecast compared(const Mode& mode, const Vector& end, const Vector& exact) {
  ModeForecast result;
  const Vector off = end - exact;
  result.error = std::abs(mode.stiffness) > 0.0 ? sizeOf(mode, off) : static_cast<double>(std::abs(off[0]));
  result.position = static_cast<double>(off[0]);
  result.size = sizeOf(mode, end);
  result.exactSize = sizeOf(mode, exact);
  if (!std::isfinite(result.error)) {
    result.error = result.position = result.size = std::numeric_limits<double>::infinity();
  }
  return result;
}

/// Damped frequency [1/s]; 0 where nothing oscillates.
double frequencyOf(const Mode& mode) {
  const double half = 0.5 * (mode.damping + mode.drag);
  return std::sqrt(std::max(0.0, mode.stiffness - half * half));
}

/// Errors of amplitude and phase from a step's leading eigenvalue: the ends alone would count what comes and goes.
void inTheLongRun(ModeForecast& result, const Mode& mode, std::complex<double> eigenvalue, double T) {
  const double omega = frequencyOf(mode), h = T / result.steps;
  result.growth = std::abs(eigenvalue);
  if (omega == 0.0 || eigenvalue.imag() == 0.0) return;
  const double decay = 0.5 * (mode.damping + mode.drag);
  result.amplitude = std::expm1(result.steps * (std::log(result.growth) + decay * h));
  result.phase = result.steps * (std::arg(eigenvalue) - omega * h);
}

/// The start of a mode whose ringing is over at once: where the fast part has carried it, on the slow way home.
Vector onTheSlowWay(const Mode& mode) {
  const double d = mode.damping + mode.drag;
  const double x = mode.amplitude + mode.speed / d;
  return {x, -mode.stiffness / d * x};
}

/// Whether a step turns the fast part round.
bool overshoots(const Block& step) { return step.trace() < 0 || step.determinant() < 0; }

}  // namespace

double exactSize(const Mode& mode, double duration) {
  return sizeOf(mode, exponential(durationOf(mode, duration) * generator(mode)) * startOf(mode));
}

std::optional<ModeForecast> forecast(const engine::MethodInfo& method, const Mode& mode, double h, double duration) {
  const double T = durationOf(mode, duration);
  const auto steps = std::max<long long>(mode.leastSteps, static_cast<long long>(std::ceil(T / h - 1e-9)));
  const Real length = Real(T) / static_cast<Real>(steps);  // the last step is cut
  Vector start = startOf(mode), exact = exponential(T * generator(mode)) * start, end;
  std::complex<double> eigenvalue;
  if (method.id == "bdf2") {
    const TwoStep two = bdf2(length * generator(mode));
    Eigen::Matrix<Real, 4, 1> pair;
    pair << two.first * start, start;
    end = (power(two.step, steps - 1) * pair).head<2>();
    eigenvalue = leadingEigenvalue(two.step);
  } else if (method.id == "velocity_verlet" && mode.damping != 0.0 && !mode.startsAfresh) {
    if (mode.cannotPull && overshoots(verlet(mode, length))) start = onTheSlowWay(mode);
    const Pair step = predictedVerlet(mode, length);
    Eigen::Matrix<Real, 4, 1> all;
    all << start, -mode.stiffness * start[0] - mode.damping * start[1], 0;
    end = (power(step, steps) * all).head<2>();
    eigenvalue = leadingEigenvalue(step);
  } else {
    const std::optional<Block> step = stepMatrix(method.id, mode, length);
    if (!step) return std::nullopt;
    if (mode.cannotPull && overshoots(*step)) start = onTheSlowWay(mode);
    end = power(*step, steps) * start;
    eigenvalue = leadingEigenvalue(*step);
  }
  ModeForecast result = compared(mode, end, exact);
  result.steps = static_cast<double>(steps);
  inTheLongRun(result, mode, eigenvalue, T);
  return result;
}

std::optional<ModeForecast> measuredForecast(const engine::MethodInfo& method, const Mode& mode, const ModeRun& run) {
  engine::TestOscillator oscillator;
  oscillator.stiffness = mode.stiffness;
  oscillator.damping = mode.damping;
  oscillator.drag1 = mode.drag;
  const double T = durationOf(mode, run.duration);
  engine::RunOptions options = run.h > 0.0 ? fixedStep(run.h, T) : withTolerance(run.tolerance, T);
  options.largestStep = mode.leastSteps > 0 ? std::min(run.largestStep, T / mode.leastSteps) : run.largestStep;
  options.mostForceEvaluations = run.budget;
  const State start{0.0, {mode.amplitude}, {mode.speed}, {}};
  engine::RunResult result;
  try {
    result = engine::simulate(oscillator, *engine::makeMethod(method.id), start, options);
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
  const Vector end(result.last.x[0], result.last.v[0]), exact = exponential(T * generator(mode)) * startOf(mode);
  ModeForecast found = compared(mode, end, exact);
  found.steps = static_cast<double>(result.work.steps);
  found.evaluations = static_cast<double>(result.work.forceEvaluations);
  if (result.failed()) {
    found.growth = found.error = found.size = std::numeric_limits<double>::infinity();
  } else if (const double omega = frequencyOf(mode); omega > 0.0 && found.exactSize > 0.0) {
    const double w = std::sqrt(mode.stiffness);
    const Real turned =
        std::atan2(end[0] * exact[1] / w - exact[0] * end[1] / w, end[0] * exact[0] + end[1] * exact[1] / (w * w));
    found.amplitude = found.size / found.exactSize - 1.0;
    found.phase = static_cast<double>(turned);
  }
  return found;
}

}  // namespace muelle::hard_cases
