#include "engine/integrators/explicit/engines/stage_integrator.h"
#include "engine/integrators/explicit/methods.h"

namespace muelle::engine {

namespace {

MethodInfo rungeKutta4Info() {
  MethodInfo info;
  info.id = "runge_kutta_4";
  info.name = "classical Runge-Kutta";
  info.order = 4;
  info.stages = 4;
  info.conservesMomentum = true;
  info.imaginaryLimit = 2.8284271247461900976;  // 2 sqrt(2)
  info.realLimit = 2.78529356340528162353;      // the real root of R(-y) = 1 but 0
  info.formula = "y+ = y + h/6 (k1 + 2 k2 + 2 k3 + k4), k2 and k3 at the middle, k4 at the end";
  info.source = "Kutta, Zeitschrift fuer Mathematik und Physik 46 (1901) 435-453";
  info.remark =
      "an undamped oscillator's energy falls by (h omega)^6 / 72 a step: good for short runs, slowly dead in long ones";
  return info;
}

}  // namespace

/// R(z) = 1 + z + z^2/2 + z^3/6 + z^4/24.
ButcherTableau rungeKutta4Tableau() {
  return {
      .c = {0.0L, 0.5L, 0.5L, 1.0L},
      .a = {{}, {0.5L}, {0.0L, 0.5L}, {0.0L, 0.0L, 1.0L}},
      .b = {1.0L / 6.0L, 1.0L / 3.0L, 1.0L / 3.0L, 1.0L / 6.0L},
  };
}

std::unique_ptr<Integrator> rungeKutta4() {
  static const StagePlan plan(rungeKutta4Info(), rungeKutta4Tableau());
  return std::make_unique<StageIntegrator>(plan);
}

}  // namespace muelle::engine
