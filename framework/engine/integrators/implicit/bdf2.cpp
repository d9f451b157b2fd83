#include "engine/integrators/implicit/implicit_method.h"
#include "engine/integrators/implicit/methods.h"

#include <cmath>

namespace muelle::engine {

namespace {

MethodInfo facts() {
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
  Bdf2() : ImplicitMethod(facts()) {}

  StepResult step(const System& system, const State& from, double h, State& to) override {
    const bool continues = known_ && from.t == end_.t && from.x == end_.x && from.v == end_.v && h <= 2.0 * lastStep_;
    StepResult result = continues ? multistep(system, from, h, to) : firstStep(system, from, h, to);
    if (!result.done) return result;
    result = finish(from, h, to);
    pendingEnd_ = to;
    pendingStep_ = h;
    pendingDx_ = vector(to.x) - vector(from.x);
    pendingDv_ = vector(to.v) - vector(from.v);
    return result;
  }

  void accept() override {
    std::swap(end_, pendingEnd_);
    std::swap(dx_, pendingDx_);
    std::swap(dv_, pendingDv_);
    lastStep_ = pendingStep_;
    known_ = true;
  }
  void restart() override { known_ = false; }

 private:
  StepResult multistep(const System& system, const State& from, double h, State& to) {
    const double r = h / lastStep_;
    const double memory = r * r / (1.0 + 2.0 * r);
    const double gamma = (1.0 + r) / (1.0 + 2.0 * r);
    stage_.V0 = vector(from.v) + memory * dv_;
    stage_.X0 = vector(from.x) + memory * dx_ + (gamma * h) * stage_.V0;
    return implicitStage(system, from, from.t + h, gamma * h, h, to);
  }

  /// Alexander's SDIRK2: gamma = 1 - 1/sqrt(2), the second stage is the step.
  StepResult firstStep(const System& system, const State& from, double h, State& to) {
    const double gamma = 1.0 - std::sqrt(0.5);
    stage_.V0 = vector(from.v);
    stage_.X0 = vector(from.x) + (gamma * h) * stage_.V0;
    StepResult result = implicitStage(system, from, from.t + gamma * h, gamma * h, h, to);
    if (!result.done) return result;
    const Vector firstV = vector(to.v);
    stage_.V0 = vector(from.v) + ((1.0 - gamma) / gamma) * w_;
    stage_.X0 = vector(from.x) + ((1.0 - gamma) * h) * firstV + (gamma * h) * stage_.V0;
    return implicitStage(system, from, from.t + h, gamma * h, h, to);
  }

  /// Solves v = V0 + c a(t, x, v), x = X0 + c (v - V0) into `to`.
  StepResult implicitStage(const System& system, const State& from, double t, double c, double h, State& to) {
    stage_.t = t;
    stage_.tau = c;
    stage_.alpha = c;
    stage_.beta = 1.0;
    stage_.z = from.z;
    w_.setZero();
    NewtonOptions options;
    options.tolerance = tolerance_;
    const StepResult result = solveStage(system, options, h);
    if (!result.done) return result;
    vector(to.v) = stage_.V0 + w_;
    vector(to.x) = stage_.X0 + c * w_;
    return result;
  }

  bool known_ = false;
  State end_, pendingEnd_;
  double lastStep_ = 0.0, pendingStep_ = 0.0;
  Vector dx_, dv_, pendingDx_, pendingDv_;
};

}  // namespace

std::unique_ptr<Method> bdf2() { return std::make_unique<Bdf2>(); }

}  // namespace muelle::engine
