#include "engine/control/closed_form.h"

#include <cmath>

namespace muelle::engine {

namespace {

/// Of y'' + damping y' + stiffness y = 0 after a time h, with g half the damping: e^(-g h) C - 1 and e^(-g h) S, where
/// C and S are cos(w h) and sin(w h) / w, w^2 = stiffness - g^2, or their hyperbolic counterparts. Without cancellation
/// for short times.
struct Oscillation {
  double cosineLessOne, sine;
};

Oscillation oscillation(double stiffness, double damping, double h) {
  const double g = 0.5 * damping, square = stiffness - g * g;
  if (square > 0.0) {
    const double w = std::sqrt(square), decay = std::exp(-g * h), half = std::sin(0.5 * w * h);
    return {std::expm1(-g * h) - 2.0 * decay * half * half, decay * std::sin(w * h) / w};
  }
  const double k = std::sqrt(-square), slow = k > 0.0 ? -stiffness / (g + k) : -g;  // (k - g) without cancellation
  const double fast = -(g + k);
  const double sine = k > 0.0 ? -std::exp(slow * h) * std::expm1(-2.0 * k * h) / (2.0 * k) : h * std::exp(-g * h);
  return {0.5 * (std::expm1(slow * h) + std::expm1(fast * h)), sine};
}

}  // namespace

void closedFormIncrement(const State& from, double h, const LaneMotion& motion, State& increment) {
  increment.t = from.t;
  increment.z = from.z;
  increment.x.resize(from.x.size());
  increment.v.resize(from.v.size());
  for (std::size_t i = 0; i < from.x.size(); ++i) {
    const double v = from.v[i], a = motion.acceleration(from, i);
    if (motion.isUniform() || motion.stiffness[i] == 0.0) {
      increment.x[i] = h * (v + 0.5 * h * a);
      increment.v[i] = h * a;
      continue;
    }
    const double K = motion.stiffness[i], C = motion.damping[i];
    const Oscillation o = oscillation(K, C, h);
    const double y = -(a + C * v) / K;  // from the place of rest
    increment.x[i] = y * o.cosineLessOne + (v + 0.5 * C * y) * o.sine;
    increment.v[i] = v * o.cosineLessOne + (a + 0.5 * C * v) * o.sine;
  }
}

void moveInClosedForm(const State& from, double h, const LaneMotion& motion, State& to) {
  closedFormIncrement(from, h, motion, to);
  to.t += h;
  for (std::size_t i = 0; i < from.x.size(); ++i) {
    to.x[i] += from.x[i];
    to.v[i] += from.v[i];
  }
}

}  // namespace muelle::engine
