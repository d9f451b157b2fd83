#include "engine/control/step_controller.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace muelle::engine {

StepController::StepController(int order, double h, double largestStep)
    : beta_(0.3 / order), exponent_(1.0 / order - 0.75 * beta_), h_(std::min(h, largestStep)), largest_(largestStep) {}

void StepController::accept(double length, double error) {
  const double bounded = std::max(error, 1e-10);
  double factor = 0.9 * std::pow(bounded, -exponent_) * std::pow(lastError_, beta_);
  factor = std::clamp(factor, 0.2, afterRejection_ ? 1.0 : 10.0);
  if (factor > 0.8 && factor < 1.0) factor = 1.0;  // the dead band
  const double proposed = length * factor;
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
