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

/// A step of h is cut into substeps; in each the constraints are projected once, in order (ConstraintProjection).
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
    system.constraints()->project(t + h, state.z,
                                  {h, inverseMass_.data(), before_.data(), state.x.data(), state.v.data()});
  }

  int substeps_;
  std::vector<double> before_;
};

}  // namespace

std::unique_ptr<Integrator> xpbd(int substeps) { return std::make_unique<Xpbd>(substeps); }

}  // namespace muelle::engine
