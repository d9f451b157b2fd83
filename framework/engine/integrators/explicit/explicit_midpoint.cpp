#include "engine/integrators/explicit/engines/stage_integrator.h"
#include "engine/integrators/explicit/methods.h"

namespace muelle::engine {

namespace {

MethodInfo explicitMidpointInfo() {
  MethodInfo info;
  info.id = "explicit_midpoint";
  info.name = "explicit midpoint";
  info.order = 2;
  info.stages = 2;
  info.conservesMomentum = true;
  info.stability = Stability::Never;
  info.imaginaryLimit = 0.0;
  info.realLimit = 2.0;
  info.formula = "y' = g(t, y), y = (x, v):  y+ = y + h g(t + h/2, y + h/2 g(t, y))";
  info.source = "Runge, Math. Annalen 46 (1895) 167-178";
  info.remark =
      "an undamped oscillator's energy grows by (h omega)^4 / 4 a step, slowly enough to be missed; velocity Verlet "
      "has "
      "the same order at half the cost and no growth";
  return info;
}

}  // namespace

/// R(z) = 1 + z + z^2/2.
ButcherTableau explicitMidpointTableau() { return {.c = {0.0L, 0.5L}, .a = {{}, {0.5L}}, .b = {0.0L, 1.0L}}; }

std::unique_ptr<Integrator> explicitMidpoint() {
  static const StagePlan plan(explicitMidpointInfo(), explicitMidpointTableau());
  return std::make_unique<StageIntegrator>(plan);
}

}  // namespace muelle::engine
