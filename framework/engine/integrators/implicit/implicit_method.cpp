#include "engine/integrators/implicit/implicit_method.h"

#include <fmt/format.h>
#include <limits>
#include <stdexcept>
#include <utility>

namespace muelle::engine {

ImplicitMethod::ImplicitMethod(MethodInfo info) : info_(std::move(info)) {}

void ImplicitMethod::prepare(const System& system, const Tolerance& tolerance) {
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
  for (Vector* v : {&stage_.X0, &stage_.V0, &w_}) v->setZero(n);
  restart();
}

StepResult ImplicitMethod::solveStage(const System& system, const NewtonOptions& options, double h) {
  const NewtonReport report = newton_.solve(system, stage_, options, w_, work_);
  StepResult result;
  result.done = report.done;
  if (!report.done) result.failure = fmt::format("{} with h = {:.6g} s: {}", info_.id, h, report.failure);
  return result;
}

StepResult ImplicitMethod::finish(const State& from, double h, State& to) const {
  to.t = from.t + h;
  to.z = from.z;
  StepResult result;
  result.done = vector(to.x).allFinite() && vector(to.v).allFinite();
  if (!result.done) result.failure = fmt::format("{} with h = {:.6g} s: the new state is not finite", info_.id, h);
  return result;
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
