#include "engine/integrators/implicit/implicit_method.h"
#include "engine/integrators/implicit/methods.h"
#include "engine/solve/spans.h"

#include <fmt/format.h>
#include <algorithm>

namespace muelle::engine {

namespace {

MethodInfo discreteGradientInfo() {
  MethodInfo info = implicitInfo("discrete_gradient", "discrete gradient", 2, Stability::AStable);
  info.reversible = true;
  info.conservesEnergy = true;
  info.conservesAngularMomentum = true;
  info.needs.potential = true;
  info.formula = "M (v1 - v0) = h F(x0, x1),  x1 - x0 = h (v0 + v1) / 2,  F(x0, x1) . (x1 - x0) = E(x0) - E(x1)";
  info.source = "Gonzalez: Time Integration and Discrete Hamiltonian Systems, 1996; Greenspan 1984 for springs";
  info.remark =
      "Energy to round-off at every step, by construction: damped scenes lose exactly what the damper takes. Phases "
      "are those of implicit midpoint, fast modes ring (|R| -> 1). Large steps on stiff scenes may have no solution "
      "that the iteration finds: it gives up after 50 Newton steps on one step, halvings included. R(z) = (1 + z/2) / "
      "(1 - z/2).";
  return info;
}

/// The conservative forces by their discrete gradient between the ends, all others at the midpoint. Solved for
/// w = v1 - v0 by Newton steps with the Jacobian at the midpoint, which differs from that of the discrete gradient by
/// O(h^2), until the residual falls no further: what is left of it is left in the energy.
class DiscreteGradient final : public ImplicitMethod {
 public:
  DiscreteGradient() : ImplicitMethod(discreteGradientInfo()) {}

 private:
  StepResult advance(const DynamicalSystem& system, const State& from, double h) override {
    const double tm = from.t + 0.5 * h;
    const bool complete = system.potential()->isComplete();
    setMidpointStage(from, h);
    stage_.forceCost = complete ? 1 : 3;
    rest_.resize(stage_.X0.size());
    conservative_.resize(stage_.X0.size());
    stage_.force = [&](const Vector& w, const Vector& X, const Vector& V, Vector& F) {
      end(from, h, w);
      system.potential()->discreteGradientForce(tm, from.x, spanOf(end_), from.z, spanOf(F));
      if (complete) return;
      system.force(tm, spanOf(X), spanOf(V), from.z, spanOf(rest_));
      system.potential()->conservativeForce(tm, spanOf(X), from.z, spanOf(conservative_));
      F += rest_ - conservative_;
    };
    StepResult result = solveWithinBudget(system, from, h);
    stage_.force = nullptr;
    end(from, h, w_);
    dv_ = w_;
    return result;
  }

  /// The Newton steps of attempts at one step that failed are counted together, halvings included: where the equation
  /// has no solution near, shorter and shorter steps would look for it for ever.
  StepResult solveWithinBudget(const DynamicalSystem& system, const State& from, double h) {
    if (failedAt_.t != from.t || failedAt_.x != from.x || failedAt_.v != from.v) spent_ = 0;
    const long long before = work_.newtonIterations;
    NewtonOptions options;
    options.tolerance = tolerance_;
    options.simplified = true;
    options.mostIterations = std::min(stepsAnAttempt, mostNewtonSteps - spent_);
    w_.setZero();
    StepResult result = solveStage(system, options, h);
    if (result.done) {
      spent_ = 0;
      return result;
    }
    spent_ += static_cast<int>(work_.newtonIterations - before);
    failedAt_ = from;
    result.retry = spent_ < mostNewtonSteps;
    if (!result.retry) {
      result.failure += fmt::format(
          "; {} Newton steps are spent on this step, halvings included: take a smaller step, or a method that damps "
          "(tr_bdf2)",
          spent_);
    }
    return result;
  }

  /// Change of position and end of the step for the increment w: the same numbers that the discrete gradient saw.
  void end(const State& from, double h, const Vector& w) {
    dx_ = h * (vector(from.v) + 0.5 * w);
    end_ = vector(from.x) + dx_;
  }

  static constexpr int mostNewtonSteps = 50;  ///< on one step, halvings included
  static constexpr int stepsAnAttempt = 12;

  Vector end_, rest_, conservative_;
  State failedAt_;  ///< start of the step that failed last
  int spent_ = 0;   ///< Newton steps on it
};

}  // namespace

std::unique_ptr<Integrator> discreteGradient() { return std::make_unique<DiscreteGradient>(); }

}  // namespace muelle::engine
