#include "engine/integrators/implicit/implicit_method.h"
#include "engine/integrators/implicit/methods.h"

#include <fmt/format.h>

namespace muelle::engine {

namespace {

MethodInfo linearisedBackwardEulerInfo() {
  MethodInfo info =
      implicitInfo("linearised_backward_euler", "linearised backward Euler (Baraff-Witkin)", 1, Stability::LStable);
  info.formula = "(M + h D + h^2 K) (v1 - v0) = h (F(t1, x0, v0) - h K v0),  x1 = x0 + h v1";
  info.source = "Baraff, Witkin: Large Steps in Cloth Simulation, SIGGRAPH 1998, eq. 16";
  info.remark =
      "One Newton step from x0: the equation of backward Euler is not solved, its residual of size h^2 |K'| |h v|^2 "
      "stays as an error; it shows when a step turns or stretches springs by much. Stable on linear systems only. "
      "Where "
      "the matrix is indefinite (compressed springs) the projected one is used. R(z) = 1 / (1 - z).";
  return info;
}

/// The first Newton iteration of backward Euler from x = x0, v = v0, taken whole. K v0 is taken with the same form of
/// K as the matrix, so that a projected step is the exact step of a projected linear model.
class LinearisedBackwardEuler final : public ImplicitMethod {
 public:
  LinearisedBackwardEuler() : ImplicitMethod(linearisedBackwardEulerInfo()) {}

 private:
  StepResult advance(const DynamicalSystem& system, const State& from, double h) override {
    const double t = from.t + h;
    const auto n = static_cast<Eigen::Index>(from.x.size());
    force_.resize(n);
    system.force(t, from.x, from.v, from.z, {force_.data(), from.x.size()});
    ++work_.forceEvaluations;
    StepResult result;
    const std::string failure = solve(system, from, t, h, Form::Symmetric);
    if (!failure.empty()) result.failure = solve(system, from, t, h, Form::Projected);
    if (!result.failure.empty()) {
      result.done = false;
      result.failure = fmt::format("{} with h = {:.6g} s: {}", info_.id, h, result.failure);
      return result;
    }
    dv_ = w_;
    dx_ = h * (vector(from.v) + w_);
    return result;
  }

  /// Empty, or why there is no w_.
  std::string solve(const DynamicalSystem& system, const State& from, double t, double h, Form form) {
    const Vector v0 = vector(from.v);
    system.linearisation()->assemble(0.0, 0.0, 1.0, t, from.x, from.v, from.z, form, J_);
    multiply(J_, v0, stiffnessTimesV_);
    system.linearisation()->assemble(1.0, h, h * h, t, from.x, from.v, from.z, form, J_);
    work_.jacobians += 2;
    const Factorisation found = solver_.factorise(J_, true);
    ++work_.factorisations;
    if (!found.usable) return found.failure;
    right_ = h * (force_ - h * stiffnessTimesV_);
    ++work_.solves;
    return solver_.solve(right_, w_);
  }

  LinearSolver solver_;
  SystemMatrix J_;
  Vector force_, stiffnessTimesV_, right_;
};

}  // namespace

std::unique_ptr<Integrator> linearisedBackwardEuler() { return std::make_unique<LinearisedBackwardEuler>(); }

}  // namespace muelle::engine
