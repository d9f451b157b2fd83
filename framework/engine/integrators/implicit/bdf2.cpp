#include "engine/integrators/implicit/implicit_method.h"
#include "engine/integrators/implicit/methods.h"

#include <cmath>

namespace muelle::engine {

namespace {

MethodInfo bdf2Info() {
  MethodInfo info = implicitInfo("bdf2", "BDF2", 2, Stability::LStable);
  info.formula = "y1 = y0 + r^2/(1+2r) (y0 - y-1) + h (1+r)/(1+2r) f(t1, y1),  r = h / h-1;  y = (x, v)";
  info.source = "Hairer, Norsett, Wanner: Solving Ordinary Differential Equations I, III.5; first step: Alexander 1977";
  info.remark =
      "Second order that still kills fast modes. Damps slow modes by a factor 1 - (h w)^4 / 4 a step. Remembers one "
      "step: starts, and starts again after an event, with the two-stage L-stable SDIRK method of order 2.";
  return info;
}

/// Variable-step BDF2 in increments (no difference of large numbers). Zero-stable for r < 1 + sqrt(2); beyond 2 the
/// history is dropped.
class Bdf2 final : public ImplicitMethod {
 public:
  Bdf2() : ImplicitMethod(bdf2Info()) {}

  void accept() override {
    std::swap(end_, pendingEnd_);
    lastDx_ = dx_;
    lastDv_ = dv_;
    lastStep_ = pendingStep_;
    known_ = true;
  }
  void restart() override { known_ = false; }

 private:
  StepResult advance(const DynamicalSystem& system, const State& from, double h) override {
    const bool continues = known_ && follows(from, end_, h) && h <= 2.0 * lastStep_;
    const StepResult result = continues ? multistep(system, from, h) : firstStep(system, from, h);
    pendingEnd_ = from;
    pendingEnd_.t += h;
    vector(pendingEnd_.x) += dx_;
    vector(pendingEnd_.v) += dv_;
    pendingStep_ = h;
    return result;
  }

  StepResult multistep(const DynamicalSystem& system, const State& from, double h) {
    const double r = h / lastStep_;
    const double memory = r * r / (1.0 + 2.0 * r);
    const double c = (1.0 + r) / (1.0 + 2.0 * r) * h;
    stage_.V0 = vector(from.v) + memory * lastDv_;
    stage_.X0 = vector(from.x) + memory * lastDx_ + c * stage_.V0;
    const StepResult result = implicitStage(system, from, from.t + h, c, h);
    dv_ = memory * lastDv_ + w_;
    dx_ = memory * lastDx_ + c * (vector(from.v) + dv_);
    return result;
  }

  /// Alexander's SDIRK2: gamma = 1 - 1/sqrt(2), the second stage is the step.
  StepResult firstStep(const DynamicalSystem& system, const State& from, double h) {
    const double gamma = 1.0 - std::sqrt(0.5), c = gamma * h;
    stage_.V0 = vector(from.v);
    stage_.X0 = vector(from.x) + c * stage_.V0;
    const StepResult result = implicitStage(system, from, from.t + c, c, h);
    if (!result.done) return result;
    dx_ = (h - c) * (vector(from.v) + w_);
    dv_ = ((1.0 - gamma) / gamma) * w_;
    stage_.V0 = vector(from.v) + dv_;
    stage_.X0 = vector(from.x) + dx_ + c * stage_.V0;
    const StepResult second = implicitStage(system, from, from.t + h, c, h);
    dv_ += w_;
    dx_ += c * (vector(from.v) + dv_);
    return second;
  }

  /// Solves w = c a(t, X0 + c w, V0 + w).
  StepResult implicitStage(const DynamicalSystem& system, const State& from, double t, double c, double h) {
    stage_.t = t;
    stage_.tau = c;
    stage_.alpha = c;
    stage_.beta = 1.0;
    stage_.z = from.z;
    w_.setZero();
    NewtonOptions options;
    options.tolerance = tolerance_;
    return solveStage(system, options, h);
  }

  bool known_ = false;
  State end_, pendingEnd_;
  double lastStep_ = 0.0, pendingStep_ = 0.0;
  Vector lastDx_, lastDv_;
};

}  // namespace

std::unique_ptr<Integrator> bdf2() { return std::make_unique<Bdf2>(); }

}  // namespace muelle::engine
