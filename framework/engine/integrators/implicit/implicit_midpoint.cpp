#include "engine/integrators/implicit/implicit_method.h"
#include "engine/integrators/implicit/methods.h"

namespace muelle::engine {

namespace {

MethodInfo implicitMidpointInfo() {
  MethodInfo info = implicitInfo("implicit_midpoint", "implicit midpoint", 2, Stability::AStable);
  info.symplectic = true;
  info.reversible = true;
  info.conservesAngularMomentum = true;
  info.formula = "xm = x0 + h vm / 2,  vm = v0 + h M^-1 F(tm, xm, vm) / 2,  x1 = x0 + h vm,  v1 = 2 vm - v0";
  info.source = "Hairer, Lubich, Wanner: Geometric Numerical Integration, II.1.3, VI.4";
  info.remark =
      "Keeps quadratic invariants, so a linear system's energy. Fast modes are not damped but ring (|R| -> 1), and a "
      "stiff non-linear scene with a large step can gain energy. R(z) = (1 + z/2) / (1 - z/2).";
  return info;
}

/// M w = h F(tm, x0 + h (v0 + w/2) / 2, v0 + w/2), v1 = v0 + w, x1 = x0 + h (v0 + w/2).
///
/// Solved for the increment w: forming v1 = 2 vm - v0, or a matrix (1 + z/2) / (1 - z/2) that is not quite of unit
/// modulus in floating point, would let the energy drift by a biased round-off.
class ImplicitMidpoint final : public ImplicitMethod {
 public:
  ImplicitMidpoint() : ImplicitMethod(implicitMidpointInfo()) {}

 private:
  StepResult advance(const DynamicalSystem& system, const State& from, double h) override {
    setMidpointStage(from, h);
    w_.setZero();
    NewtonOptions options;
    options.tolerance = tolerance_;
    options.polish = true;
    const StepResult result = solveStage(system, options, h);
    dv_ = w_;
    dx_ = h * (stage_.V0 + 0.5 * w_);
    return result;
  }
};

}  // namespace

std::unique_ptr<Integrator> implicitMidpoint() { return std::make_unique<ImplicitMidpoint>(); }

}  // namespace muelle::engine
