#include "engine/integrators/implicit/implicit_method.h"
#include "engine/integrators/implicit/methods.h"

namespace muelle::engine {

namespace {

MethodInfo newmarkInfo() {
  MethodInfo info = implicitInfo("newmark", "Newmark, average acceleration", 2, Stability::AStable);
  info.reversible = true;
  info.formula = "x1 = x0 + h v0 + h^2 (a0 + a1) / 4,  v1 = v0 + h (a0 + a1) / 2   (beta = 1/4, gamma = 1/2)";
  info.source =
      "Newmark: A Method of Computation for Structural Dynamics, 1959; Hughes: The Finite Element Method, 9.1";
  info.remark =
      "The trapezoidal rule: keeps a linear system's energy, does not damp fast modes (|R| -> 1), and can gain energy "
      "on stiff non-linear scenes. R(z) = (1 + z/2) / (1 - z/2).";
  return info;
}

/// M w = h (F0 + F1) / 2 with w = v1 - v0, x1 = x0 + h (v0 + w/2). The force at the start is that of the last step's
/// end, when it is the same state.
class Newmark final : public ImplicitMethod {
 public:
  Newmark() : ImplicitMethod(newmarkInfo()) {}

  void accept() override {
    std::swap(end_, last_);
    force_ = newton_.force();
  }
  void restart() override { known_ = false; }

 private:
  StepResult advance(const DynamicalSystem& system, const State& from, double h) override {
    if (!known_ || from.z != end_.z || !follows(from, end_, h)) {
      force_.resize(static_cast<Eigen::Index>(from.x.size()));
      system.force(from.t, from.x, from.v, from.z, {force_.data(), from.x.size()});
      ++work_.forceEvaluations;
      end_ = from;
      known_ = true;
    }
    stage_.t = from.t + h;
    stage_.tau = 0.5 * h;
    stage_.alpha = 0.5 * h;
    stage_.beta = 1.0;
    stage_.z = from.z;
    stage_.g = (0.5 * h) * force_;
    stage_.V0 = vector(from.v);
    stage_.X0 = vector(from.x) + h * stage_.V0;
    w_.setZero();
    NewtonOptions options;
    options.tolerance = tolerance_;
    options.polish = true;
    const StepResult result = solveStage(system, options, h);
    dv_ = w_;
    dx_ = h * (stage_.V0 + 0.5 * w_);
    last_ = from;
    last_.t += h;
    vector(last_.x) += dx_;
    vector(last_.v) += dv_;
    return result;
  }

  bool known_ = false;
  State end_, last_;
  Vector force_;
};

}  // namespace

std::unique_ptr<Integrator> newmark() { return std::make_unique<Newmark>(); }

}  // namespace muelle::engine
