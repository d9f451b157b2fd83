#include "engine/integrators/implicit/implicit_method.h"

#include "engine/integrators/cubic_interpolant.h"
#include "engine/solve/spans.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace muelle::engine {

ImplicitMethod::ImplicitMethod(MethodInfo info) : info_(std::move(info)) {}

void ImplicitMethod::prepare(const DynamicalSystem& system, const Tolerance& tolerance) {
  if (system.linearisation() == nullptr) {
    throw std::invalid_argument(
        fmt::format("{} needs the derivatives of the force (linearisation), which this system lacks", info_.id));
  }
  if (info_.needs.potential && system.potential() == nullptr) {
    throw std::invalid_argument(
        fmt::format("{} needs an energy from which the forces derive (potential), which this system lacks", info_.id));
  }
  tolerance_ = tolerance.newton;
  newton_.prepare(system);
  compact_.emplace(system);
  const auto n = static_cast<Eigen::Index>(system.size());
  stage_ = {};
  for (Vector* v : {&stage_.X0, &stage_.V0, &w_, &dx_, &dv_}) v->setZero(n);
  restart();
}

void ImplicitMethod::setMidpointStage(const State& from, double h) {
  stage_.t = from.t + 0.5 * h;
  stage_.tau = h;
  stage_.alpha = 0.25 * h;
  stage_.beta = 0.5;
  stage_.z = from.z;
  stage_.V0 = vector(from.v);
  stage_.X0 = vector(from.x) + (0.5 * h) * stage_.V0;
}

StepResult ImplicitMethod::solveStage(const DynamicalSystem& system, const NewtonOptions& options, double h) {
  const NewtonReport report = newton_.solve(system, stage_, options, w_, work_);
  StepResult result;
  result.done = report.done;
  if (!report.done) result.failure = fmt::format("{} with h = {:.6g} s: {}", info_.id, h, report.failure);
  return result;
}

/// Advances, and makes `to` as long as `from`, with its time and internal variables.
StepResult ImplicitMethod::advanceWhole(const DynamicalSystem& system, const State& from, double h, State& to) {
  compact_->follow(from);
  compact_->compact(from, from_);
  StepResult result = advance(*compact_, from_, h);
  if (!result.done) return result;
  to.t = from.t + h;
  to.z = from.z;
  to.x.resize(static_cast<std::size_t>(system.storage()));
  to.v.resize(to.x.size());
  result.done = dx_.allFinite() && dv_.allFinite();
  if (!result.done) result.failure = fmt::format("{} with h = {:.6g} s: the new state is not finite", info_.id, h);
  return result;
}

StepResult ImplicitMethod::step(const DynamicalSystem& system, const State& from, double h, State& to) {
  StepResult result = advanceWhole(system, from, h, to);
  if (!result.done) return result;
  to.x = from.x;
  to.v = from.v;
  vector(from_.x) += dx_;
  vector(from_.v) += dv_;
  from_.t = to.t;
  compact_->expand(from_, to);
  return result;
}

StepResult ImplicitMethod::stepIncrement(const DynamicalSystem& system, const State& from, double h, State& increment) {
  StepResult result = advanceWhole(system, from, h, increment);
  if (!result.done) return result;
  std::ranges::fill(increment.x, 0.0);
  std::ranges::fill(increment.v, 0.0);
  compact_->scatter(spanOf(dx_), increment.x);
  compact_->scatter(spanOf(dv_), increment.v);
  return result;
}

void ImplicitMethod::interpolate(const DynamicalSystem& system, const State& from, const State& to, double theta,
                                 State& out) {
  if (info_.order <= 2) return interpolateByVelocities(from, to, theta, out);
  Integrator::interpolate(system, from, to, theta, out);
}

bool ImplicitMethod::follows(const State& from, const State& end, double h) {
  constexpr double bits = 8.0 * std::numeric_limits<double>::epsilon();
  const auto close = [](const std::vector<double>& a, const std::vector<double>& b) {
    return (vector(a) - vector(b)).lpNorm<Eigen::Infinity>() <= bits * vector(b).lpNorm<Eigen::Infinity>();
  };
  return from.x.size() == end.x.size() && std::abs(from.t - end.t) <= 1e-6 * h && close(from.x, end.x) &&
         close(from.v, end.v);
}

MethodInfo implicitInfo(std::string id, std::string name, int order, Stability stability) {
  MethodInfo info;
  info.id = std::move(id);
  info.name = std::move(name);
  info.order = order;
  info.stages = 0;
  info.implicit = true;
  info.conservesMomentum = true;
  info.stability = stability;
  info.imaginaryLimit = std::numeric_limits<double>::infinity();
  info.realLimit = std::numeric_limits<double>::infinity();
  info.needs.linearisation = true;
  return info;
}

}  // namespace muelle::engine
