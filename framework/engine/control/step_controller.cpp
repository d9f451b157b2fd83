#include "engine/control/step_controller.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace muelle::engine {

StepController::StepController(int order, double h, double largestStep)
    : beta_(0.2 / order), exponent_(1.0 / order - 0.75 * beta_), h_(std::min(h, largestStep)), largest_(largestStep) {}

void StepController::accept(double length, double error) {
  const double bounded = std::max(error, 1e-10);
  double factor = 0.9 * std::pow(bounded, -exponent_) * std::pow(lastError_, beta_);
  factor = std::clamp(factor, 0.2, afterRejection_ ? 1.0 : 10.0);
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

/// Root mean square of values over their tolerances.
class WeightedNorm {
 public:
  WeightedNorm(const State& state, const Tolerance& tolerance) : state_(state), tolerance_(tolerance) {}
  double of(const std::vector<double>& dx, const std::vector<double>& dv) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < dx.size(); ++i) {
      const double x = dx[i] / weight(state_.x[i]);
      const double v = dv[i] / weight(state_.v[i]);
      sum += x * x + v * v;
    }
    return std::sqrt(sum / (2.0 * static_cast<double>(dx.size())));
  }

 private:
  double weight(double value) const {
    return std::max(tolerance_.absolute + tolerance_.relative * std::abs(value), 1e-300);
  }
  const State& state_;
  const Tolerance& tolerance_;
};

void acceleration(const System& system, const State& state, std::vector<double>& a) {
  system.force(state.t, state.x, state.v, state.z, a);
  for (std::size_t i = 0; i < a.size(); ++i) a[i] /= system.mass()[i];
}

}  // namespace

double firstStep(const System& system, const State& start, int order, const Tolerance& tolerance, double duration,
                 Work& work) {
  const std::size_t n = start.x.size();
  std::vector<double> a0(n), a1(n), dv(n), da(n);
  acceleration(system, start, a0);
  const WeightedNorm norm(start, tolerance);
  const double size = norm.of(start.x, start.v);
  const double slope = norm.of(start.v, a0);
  double h = size < 1e-5 || slope < 1e-5 ? 1e-6 : 0.01 * size / slope;
  h = std::min(h, duration);

  State moved = start;
  moved.t += h;
  for (std::size_t i = 0; i < n; ++i) {
    moved.x[i] += h * start.v[i];
    moved.v[i] += h * a0[i];
  }
  acceleration(system, moved, a1);
  work.forceEvaluations += 2;
  for (std::size_t i = 0; i < n; ++i) {
    dv[i] = moved.v[i] - start.v[i];
    da[i] = a1[i] - a0[i];
  }
  const double curvature = norm.of(dv, da) / h;
  const double fastest = std::max(slope, curvature);
  const double guess = fastest <= 1e-15 ? std::max(1e-6, 1e-3 * h) : std::pow(0.01 / fastest, 1.0 / order);
  const double chosen = std::min({100.0 * h, guess, duration});
  return std::isfinite(chosen) && chosen > 0.0 ? chosen : 1e-6 * duration;
}

}  // namespace muelle::engine
