#include "engine/analysis/amplification.h"

#include "engine/analysis/first_failure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace muelle::engine {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Two states side by side, [x0 x1; v0 v1].
struct Matrix {
  double a, b, c, d;
  double norm() const { return std::max({std::abs(a), std::abs(b), std::abs(c), std::abs(d)}); }
};

Matrix operator*(const Matrix& l, const Matrix& r) {
  return {l.a * r.a + l.b * r.c, l.a * r.b + l.b * r.d, l.c * r.a + l.d * r.c, l.c * r.b + l.d * r.d};
}
Matrix operator-(const Matrix& l, const Matrix& r) { return {l.a - r.a, l.b - r.b, l.c - r.c, l.d - r.d}; }

double spectralRadius(const Matrix& m) {
  const double half = 0.5 * (m.a + m.d);
  const double det = m.a * m.d - m.b * m.c;
  const double discriminant = half * half - det;
  // At a double eigenvalue the discriminant is rounding, and its root far larger than that.
  const bool twice = std::abs(discriminant) <= 1e-13 * std::max(half * half, std::abs(det));
  return discriminant < 0.0 || twice ? std::sqrt(std::abs(det)) : std::abs(half) + std::sqrt(discriminant);
}

/// A matrix of determinant 1 that turns keeps the form c x^2 + (d - a) x y - b y^2: the ratio of its extreme values on
/// the unit circle, and so of the energies that one value of the form allows.
double keptFormRatio(const Matrix& m) {
  const double mean = 0.5 * (m.c - m.b);
  const double spread = std::hypot(0.5 * (m.c + m.b), 0.5 * (m.d - m.a));
  return (std::abs(mean) + spread) / (std::abs(mean) - spread);
}

/// The largest singular value, squared.
double largestStretch(const Matrix& m) {
  const double xx = m.a * m.a + m.c * m.c, xy = m.a * m.b + m.c * m.d, yy = m.b * m.b + m.d * m.d;
  return 0.5 * (xx + yy) + std::hypot(0.5 * (xx - yy), xy);
}

constexpr std::array<std::array<double, 2>, 2> unitStates = {{{1.0, 0.0}, {0.0, 1.0}}};

State unitState(int j) {
  const std::array<double, 2>& unit = unitStates[static_cast<std::size_t>(j)];
  return {0.0, {unit[0]}, {unit[1]}, {}};
}

}  // namespace

double Amplification::growth(double stiffness, double damping, double drag) {
  oscillator_.stiffness = stiffness;
  oscillator_.damping = damping;
  oscillator_.drag1 = drag;
  try {
    method_.prepare(oscillator_, {});
  } catch (const std::invalid_argument&) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  if (const MethodInfo& info = method_.info(); info.processed && damping == 0.0 && drag == 0.0) {
    return 1.0 + std::max(0.0, std::sqrt(std::max(0.0, stiffness)) - info.imaginaryLimit);
  }
  // Two steps from each of two states: a method without memory does the same twice.
  std::array<State, 2> once, twice;
  for (int j = 0; j < 2; ++j) {
    const auto i = static_cast<std::size_t>(j);
    const State from = unitState(j);
    once[i] = twice[i] = from;
    method_.restart();
    if (!method_.step(oscillator_, from, 1.0, once[i]).done) return infinite;
    method_.accept();
    if (!method_.step(oscillator_, once[i], 1.0, twice[i]).done) return infinite;
  }
  const Matrix first = {once[0].x[0], once[1].x[0], once[0].v[0], once[1].v[0]};
  const Matrix second = {twice[0].x[0], twice[1].x[0], twice[0].v[0], twice[1].v[0]};
  const Matrix square = first * first;
  const bool remembers = (second - square).norm() > 1e-9 * std::max(square.norm(), first.norm());
  return remembers ? growthWithMemory() : spectralRadius(first);
}

double Amplification::growthWithMemory() {
  // Where a slow decay goes beside, what grows has to overtake it: explicit steps are cheap.
  const int steps = method_.info().implicit ? 200 : 2000;
  std::array<double, 2> middle{}, end{};
  for (int j = 0; j < 2; ++j) {
    State from = unitState(j), to = from;
    method_.restart();
    for (int n = 1; n <= steps; ++n) {
      if (!method_.step(oscillator_, from, 1.0, to).done) return infinite;
      method_.accept();
      std::swap(from, to);
      // Over the last steps the largest size counts, so that the phase of an oscillation does not.
      double& size = n <= steps / 2 ? middle[static_cast<std::size_t>(j)] : end[static_cast<std::size_t>(j)];
      const bool counts = (n > steps / 4 && n <= steps / 2) || n > 3 * steps / 4;
      if (counts) size = std::max(size, std::hypot(from.x[0] * std::sqrt(std::abs(oscillator_.stiffness)), from.v[0]));
    }
  }
  const double before = std::max(middle[0], middle[1]), after = std::max(end[0], end[1]);
  if (!(before > 1e-290)) return 0.0;  // has died out
  return std::pow(after / before, 2.0 / steps);
}

double Amplification::energySwing(double z) {
  if (!(z > 0.0) || growth(z * z, 0.0) > 1.0 + roundingGrowth) return 1.0;
  // The columns are runs from all energy in the spring and all in the motion; in coordinates (z x, v) the energy is
  // half the square of the length.
  constexpr int steps = 400;
  std::vector<Matrix> path(steps);
  for (int j = 0; j < 2; ++j) {
    State from = unitState(j), to = from;
    from.x[0] /= z;
    method_.restart();
    for (Matrix& at : path) {
      if (!method_.step(oscillator_, from, 1.0, to).done) return 1.0;
      method_.accept();
      std::swap(from, to);
      (j == 0 ? at.a : at.b) = z * from.x[0];
      (j == 0 ? at.c : at.d) = from.v[0];
    }
  }
  const Matrix& step = path[0];
  const bool remembers = (path[1] - step * step).norm() > 1e-9;
  const bool turns = std::abs(step.a * step.d - step.b * step.c - 1.0) < 1e-9 && std::abs(step.a + step.d) < 2.0;
  if (turns && !remembers) return keptFormRatio(step);
  double most = 1.0;
  for (const Matrix& at : path) most = std::max(most, largestStretch(at));
  return most;
}

double Amplification::imaginaryLimit(double most) {
  // Methods of high order have bubbles of instability: that of the Nystroem pair of order 8 is 0.04 % wide.
  const Stability stability = method_.info().stability;
  const double ratio = stability == Stability::Limited ? 1.00025 : 1.02;
  return firstFailure([this](double z) { return growth(z * z, 0.0) <= 1.0 + roundingGrowth; }, most, false, ratio);
}

double Amplification::realLimit(double most) {
  return firstFailure([this](double z) { return growth(0.0, z) <= 1.0 + roundingGrowth; }, most);
}

}  // namespace muelle::engine
