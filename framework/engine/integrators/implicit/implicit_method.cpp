#include "engine/integrators/implicit/implicit_method.h"

#include <fmt/format.h>
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

StepResult ImplicitMethod::step(const DynamicalSystem& system, const State& from, double h, State& to) {
  StepResult result = advance(system, from, h);
  if (!result.done) return result;
  to.t = from.t + h;
  vector(to.x) = vector(from.x) + dx_;
  vector(to.v) = vector(from.v) + dv_;
  to.z = from.z;
  result.done = vector(to.x).allFinite() && vector(to.v).allFinite();
  if (!result.done) result.failure = fmt::format("{} with h = {:.6g} s: the new state is not finite", info_.id, h);
  return result;
}

StepResult ImplicitMethod::stepIncrement(const DynamicalSystem& system, const State& from, double h, State& increment) {
  StepResult result = advance(system, from, h);
  if (!result.done) return result;
  vector(increment.x) = dx_;
  vector(increment.v) = dv_;
  result.done = dx_.allFinite() && dv_.allFinite();
  if (!result.done) result.failure = fmt::format("{} with h = {:.6g} s: the new state is not finite", info_.id, h);
  return result;
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
