#include "engine/integrators/implicit/esdirk.h"

#include "engine/integrators/explicit/engines/step_finish.h"
#include "engine/solve/spans.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace muelle::engine {

Esdirk::Esdirk(MethodInfo info, EsdirkTableau tableau)
    : ImplicitMethod(std::move(info)), tableau_(std::move(tableau)), c_(tableau_.a.size(), 0.0) {
  for (std::size_t i = 1; i < c_.size(); ++i) {
    c_[i] = std::accumulate(tableau_.a[i].begin(), tableau_.a[i].end(), tableau_.diagonal);
  }
}

void Esdirk::prepare(const DynamicalSystem& system, const Tolerance& tolerance) {
  ImplicitMethod::prepare(system, tolerance);
  allowed_ = stepTolerance(tolerance.relative, info_.order, tableau_.errorPower);
  const auto n = static_cast<Eigen::Index>(system.size());
  dvs_.assign(c_.size(), Vector::Zero(n));
  as_.assign(c_.size(), Vector::Zero(n));
  for (Vector* v : {&errorX_, &errorV_, &right_, &scratch_, &probe_}) v->setZero(n);
}

void Esdirk::accept() {
  std::swap(end_, pendingEnd_);
  std::swap(as_.front(), as_.back());
  known_ = true;
}

StepResult Esdirk::advance(const DynamicalSystem& system, const State& from, double h) {
  provideFirstSlope(system, from, h);
  const double c = tableau_.diagonal * h;
  const auto v0 = vector(from.v);
  for (std::size_t i = 1; i < c_.size(); ++i) {
    dv_.setZero();
    dx_ = ((c_[i] - tableau_.diagonal) * h) * v0;
    for (std::size_t j = 0; j < i; ++j) {
      if (tableau_.a[i][j] == 0.0) continue;
      dv_ += (tableau_.a[i][j] * h) * as_[j];
      dx_ += (tableau_.a[i][j] * h) * dvs_[j];
    }
    stage_.V0 = v0 + dv_;
    stage_.X0 = vector(from.x) + dx_ + c * stage_.V0;
    w_ = c * as_[i - 1];
    if (const StepResult result = solve(system, from, i, h); !result.done) return result;
    as_[i] = w_ / c;
    dvs_[i] = dv_ + w_;
  }
  dv_ = dvs_.back();
  dx_ += c * (v0 + dv_);
  pendingEnd_ = from;
  pendingEnd_.t += h;
  vector(pendingEnd_.x) += dx_;
  vector(pendingEnd_.v) += dv_;
  StepResult result;
  result.error = error(system, from, h);
  return result;
}

void Esdirk::provideFirstSlope(const DynamicalSystem& system, const State& from, double h) {
  if (known_ && from.z == end_.z && follows(from, end_, h)) return;
  const std::span<const double> mass = system.mass();
  Vector& a = as_.front();
  system.force(from.t, from.x, from.v, from.z, {a.data(), mass.size()});
  ++work_.forceEvaluations;
  for (std::size_t i = 0; i < mass.size(); ++i) a[static_cast<Eigen::Index>(i)] /= mass[i];
  end_ = from;
  known_ = true;
}

/// Solves stage i from the guess in w_.
StepResult Esdirk::solve(const DynamicalSystem& system, const State& from, std::size_t i, double h) {
  const double c = tableau_.diagonal * h;
  stage_.t = from.t + c_[i] * h;
  stage_.tau = c;
  stage_.alpha = c;
  stage_.beta = 1.0;
  stage_.z = from.z;
  NewtonOptions options;
  options.tolerance = tolerance_;
  options.reuse = true;
  return solveStage(system, options, h);
}

/// The estimated error over the tolerance, to the power at which it falls with h^order: so the controller takes it.
double Esdirk::error(const DynamicalSystem& system, const State& from, double h) {
  errorX_.setZero();
  errorV_.setZero();
  for (std::size_t i = 0; i < c_.size(); ++i) {
    if (tableau_.error[i] == 0.0) continue;
    errorX_ += (tableau_.error[i] * h) * dvs_[i];  // v0 drops out: the weights add up to 0
    errorV_ += (tableau_.error[i] * h) * as_[i];
  }
  filterError(system, tableau_.diagonal * h);
  return std::pow(overTolerance(from), static_cast<double>(info_.order) / tableau_.errorPower);
}

double Esdirk::overTolerance(const State& from) const {
  const double position = allowed_ * errorScale_.position, velocity = allowed_ * errorScale_.velocity;
  return larger(largestErrorRatio(spanOf(errorX_), from.x, pendingEnd_.x, position),
                largestErrorRatio(spanOf(errorV_), from.v, pendingEnd_.v, velocity));
}

/// (I - c f')^-1 on the estimate, eliminated for the positions as the stages are:
/// (M + c D + c^2 K) x = M (c e_v + e_x) + c D e_x,  v = (x - e_x) / c.
void Esdirk::filterError(const DynamicalSystem& system, double c) {
  if (!newton_.hasMatrix()) return;
  const std::span<const double> mass = system.mass();
  const Eigen::Map<const Vector> m(mass.data(), static_cast<Eigen::Index>(mass.size()));
  right_ = m.cwiseProduct(c * errorV_ + errorX_);
  if (system.forceUsesVelocity()) addDamped(system, c);
  if (!newton_.solveWithLastMatrix(right_, scratch_, work_)) return;
  errorV_ = (scratch_ - errorX_) / c;
  errorX_ = scratch_;
}

/// right_ += c D e_x, from the difference of two forces: friction aside, they are linear in the velocity.
void Esdirk::addDamped(const DynamicalSystem& system, double c) {
  const double size = errorX_.lpNorm<Eigen::Infinity>();
  if (!(size > 0.0)) return;
  const Vector &x = newton_.position(), &v = newton_.velocity();
  const double way = std::max(v.lpNorm<Eigen::Infinity>(), size / c) / size;
  const auto n = static_cast<std::size_t>(v.size());
  probe_ = v + way * errorX_;
  system.force(stage_.t, {x.data(), n}, {probe_.data(), n}, stage_.z, {scratch_.data(), n});
  ++work_.forceEvaluations;
  right_ += (c / way) * (newton_.force() - scratch_);
}

}  // namespace muelle::engine
