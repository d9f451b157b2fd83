#include "engine/integrators/explicit/engines/stage_integrator.h"
#include "engine/integrators/explicit/methods.h"

namespace muelle::engine {

namespace {

MethodInfo explicitEulerInfo() {
  MethodInfo info;
  info.id = "explicit_euler";
  info.name = "explicit Euler";
  info.order = 1;
  info.stages = 1;
  info.conservesMomentum = true;
  info.stability = Stability::Never;
  info.imaginaryLimit = 0.0;
  info.realLimit = 2.0;
  info.formula = "x+ = x + h v;  v+ = v + h F(t, x, v) / m";
  info.source = "Euler, Institutiones calculi integralis (1768), section II, chapter 7";
  info.remark =
      "never for springs: each step multiplies an undamped oscillator's energy by 1 + (h omega)^2; here as the warning";
  return info;
}

}  // namespace

/// R(z) = 1 + z.
ButcherTableau explicitEulerTableau() { return {.c = {0.0L}, .a = {{}}, .b = {1.0L}}; }

std::unique_ptr<Integrator> explicitEuler() {
  static const StagePlan plan(explicitEulerInfo(), explicitEulerTableau());
  return std::make_unique<StageIntegrator>(plan);
}

}  // namespace muelle::engine
