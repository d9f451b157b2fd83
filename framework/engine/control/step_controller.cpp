#include "engine/control/step_controller.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

namespace muelle::engine {

StepController::StepController(int order, double h, double largestStep)
    : beta_(0.3 / order), exponent_(1.0 / order - 0.75 * beta_), h_(std::min(h, largestStep)), largest_(largestStep) {}

/// A logarithm by its first digits, wrong by 0.01 at most, of a normal positive number: for a look at whether an exact
/// one is needed at all.
double StepController::roughLog2(double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  const double exponent = static_cast<double>(bits >> 52U) - 1023.0;
  const double m = std::bit_cast<double>((bits & 0x000f'ffff'ffff'ffffU) | 0x3ff0'0000'0000'0000U);  // in [1, 2)
  return exponent + (2.0 - m / 3.0) * m - 5.0 / 3.0;
}

/// By how much the next step should be longer, before its bounds.
double StepController::factor(double error) const {
  const double rough = std::log2(0.9) - exponent_ * roughLog2(error) + beta_ * roughLog2(lastError_);
  const double doubt = 0.01 * (std::abs(exponent_) + beta_);
  if (rough > deadBandLog2 + doubt && rough < -doubt) return 1.0;
  const double exact = 0.9 * std::pow(error, -exponent_) * std::pow(lastError_, beta_);
  return exact > deadBand && exact < 1.0 ? 1.0 : exact;
}

void StepController::accept(double length, double error) {
  const double next = std::clamp(factor(std::max(error, 1e-10)), 0.2, afterRejection_ ? 1.0 : 10.0);
  const double proposed = length * next;
  h_ = std::min(length < 0.999 * h_ ? std::max(h_, proposed) : proposed, largest_);
  lastError_ = std::max(error, 1e-4);
  afterRejection_ = false;
}

void StepController::reject(double length, double error) {
  const double factor = std::isfinite(error) ? 0.9 * std::pow(error, -exponent_) : 0.1;
  h_ = length * std::clamp(factor, 0.1, 0.9);
  afterRejection_ = true;
}

void StepController::fail(double length) {
  h_ = 0.25 * length;
  afterRejection_ = true;
}

namespace {

double largest(const std::vector<double>& values) {
  double result = 0.0;
  for (const double value : values) result = std::max(result, std::abs(value));
  return result;
}

}  // namespace

double firstStep(const DynamicalSystem& system, const State& start, int order, double tolerance,
                 const ErrorScale& scale, double duration, Work& work) {
  const std::size_t n = start.x.size();
  std::vector<double> a0(n), a1(n);
  system.acceleration(start.t, start.x, start.v, start.z, a0);
  const double slope = std::max(scale.velocity / scale.position, largest(a0) / scale.velocity);
  const double trial = std::min(0.01 / slope, duration);

  State moved = start;
  moved.t += trial;
  for (std::size_t i = 0; i < n; ++i) {
    moved.x[i] += trial * start.v[i];
    moved.v[i] += trial * a0[i];
  }
  system.place(moved.t, moved.z, moved.x, moved.v);
  system.acceleration(moved.t, moved.x, moved.v, moved.z, a1);
  work.forceEvaluations += 2;
  for (std::size_t i = 0; i < n; ++i) a1[i] -= a0[i];
  const double curvature = std::sqrt(largest(a1) / (trial * scale.velocity));
  const double guess = std::pow(0.01 * tolerance, 1.0 / order) / std::max(slope, curvature);
  const double chosen = std::min({100.0 * trial, guess, duration});
  return std::isfinite(chosen) && chosen > 0.0 ? chosen : 1e-6 * duration;
}

}  // namespace muelle::engine
