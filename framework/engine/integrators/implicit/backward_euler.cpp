#include "engine/integrators/implicit/implicit_method.h"
#include "engine/integrators/implicit/methods.h"

namespace muelle::engine {

namespace {

MethodInfo backwardEulerInfo() {
  MethodInfo info = implicitInfo("backward_euler", "backward Euler", 1, Stability::LStable);
  info.formula = "v1 = v0 + h M^-1 F(t1, x1, v1),  x1 = x0 + h v1";
  info.source = "Hairer, Wanner: Solving Ordinary Differential Equations II, IV.3";
  info.remark =
      "Stable for every step and very damping: a mode of angular frequency w loses the factor 1 / (1 + h^2 w^2) of its "
      "energy each step. Angular momentum decays too. R(z) = 1 / (1 - z).";
  return info;
}

/// v1 = v0 + h M^-1 F(t1, x1, v1), x1 = x0 + h v1, solved for w = v1 - v0 by Newton's method with a line search on
///
///     w^T M w / 2 + E(x0 + h (v0 + w))  + the damping:
///
/// a step goes to a minimum of it, so that it leaves a saddle of the energy (Martin et al. 2011).
class BackwardEuler final : public ImplicitMethod {
 public:
  BackwardEuler() : ImplicitMethod(backwardEulerInfo()) {}

 private:
  StepResult advance(const DynamicalSystem& system, const State& from, double h) override {
    stage_.t = from.t + h;
    stage_.tau = h;
    stage_.alpha = h;
    stage_.beta = 1.0;
    stage_.z = from.z;
    stage_.V0 = vector(from.v);
    stage_.X0 = vector(from.x) + h * stage_.V0;
    w_.setZero();
    NewtonOptions options;
    options.tolerance = tolerance_;
    const StepResult result = solveStage(system, options, h);
    dv_ = w_;
    dx_ = h * (stage_.V0 + w_);
    return result;
  }
};

}  // namespace

std::unique_ptr<Integrator> backwardEuler() { return std::make_unique<BackwardEuler>(); }

}  // namespace muelle::engine
