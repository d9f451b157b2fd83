#include "base/text/count.h"
#include "engine/integrators/position_based/methods.h"
#include "engine/integrators/position_based/position_method.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace muelle::engine {

namespace {

MethodInfo xpbdInfo(int substeps) {
  MethodInfo info = positionBasedInfo("xpbd", "XPBD, " + counted(substeps, "substep"));
  info.formula = "each substep: x += h v + h^2 M^-1 F_ext; once for each C: x -= M^-1 grad C (C + g) / (w + h^-2 / k)";
  info.source = "Macklin et al.: Small Steps in Physics Simulation, 2019; XPBD, 2016";
  info.remark =
      "A baseline. One Gauss-Seidel sweep a substep does not solve the coupled equations: long or heavy chains are too "
      "soft, by an error that falls with the substeps only. Damps like backward Euler with the substep. Results depend "
      "on the order of the springs.";
  return info;
}

/// A step of h is cut into substeps; in each the constraints are projected once, in order, with the multiplier
///
///     dl = -(C + gamma grad C . (x - x0)) / ((1 + gamma) w + a),   a = 1 / (k h^2), gamma = d / (k h),
///
/// multiplied through by k h^2, so that k = 0 (a mere damper) is no special case.
class Xpbd final : public PositionMethod {
 public:
  explicit Xpbd(int substeps) : PositionMethod(xpbdInfo(substeps)), substeps_(substeps) {
    if (substeps < 1)
      throw std::invalid_argument(fmt::format("xpbd: {}; at least 1 is needed", counted(substeps, "substep")));
  }

  StepResult step(const DynamicalSystem& system, const State& from, double h, State& to) override {
    to.x = from.x;
    to.v = from.v;
    to.z = from.z;
    const double small = h / substeps_;
    for (int i = 0; i < substeps_; ++i) substep(system, from.t + small * i, small, to);
    return finish(from, h, to);
  }

 private:
  void substep(const DynamicalSystem& system, double t, double h, State& state) {
    accelerate(system, t, h, state);
    before_ = state.x;
    for (std::size_t i = 0; i < state.x.size(); ++i) state.x[i] += h * state.v[i];
    system.place(t + h, state.z, state.x, state.v);
    const Constraints& constraints = *system.constraints();
    for (int j = 0; j < constraints.count(); ++j) {
      if (constraints.evaluate(j, t + h, state.x, state.z, constraint_)) project(h, state);
    }
  }

  /// The velocity takes each correction over h: (x - before) / h would bring the rounding of x, divided by h, into the
  /// momentum.
  void project(double h, State& state) {
    std::vector<double>& x = state.x;
    const Constraint& c = constraint_;
    double w = 0.0, moved = 0.0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(c.count); ++i) {
      const auto u = static_cast<std::size_t>(c.lane[i]);
      w += c.gradient[i] * c.gradient[i] * inverseMass_[u];
      if (inverseMass_[u] > 0.0) moved += c.gradient[i] * (x[u] - before_[u]);
    }
    double multiplier = 0.0;
    if (c.compliance > 0.0) {
      const double stiffness = h * h / c.compliance, damping = h * c.damping;
      multiplier = -(stiffness * c.value + damping * moved) / ((stiffness + damping) * w + 1.0);
    } else if (w > 0.0) {
      multiplier = -c.value / w;
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(c.count); ++i) {
      const auto u = static_cast<std::size_t>(c.lane[i]);
      const double correction = multiplier * c.gradient[i] * inverseMass_[u];
      x[u] += correction;
      state.v[u] += correction / h;
    }
  }

  int substeps_;
  std::vector<double> before_;
  Constraint constraint_;
};

}  // namespace

std::unique_ptr<Integrator> xpbd(int substeps) { return std::make_unique<Xpbd>(substeps); }

}  // namespace muelle::engine
