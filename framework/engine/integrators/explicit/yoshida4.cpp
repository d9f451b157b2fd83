#include "engine/integrators/explicit/engines/composition.h"
#include "engine/integrators/explicit/methods.h"

#include <cmath>

namespace muelle::engine {

namespace {

MethodInfo yoshida4Info() {
  MethodInfo info;
  info.id = "yoshida4";
  info.name = "Yoshida 4";
  info.order = 4;
  info.stages = 3;
  info.symplectic = true;
  info.reversible = true;
  info.conservesMomentum = true;
  info.conservesAngularMomentum = true;
  info.imaginaryLimit = 1.57340194743454005663;
  info.realLimit = 0.8934;  // measured: the negative substep amplifies what damping should kill
  info.formula = "three velocity Verlet steps of g h, (1 - 2 g) h, g h with g = 1 / (2 - 2^(1/3))";
  info.source = "Yoshida, Phys. Lett. A 150 (1990) 262-268";
  info.remark =
      "long undamped runs at moderate accuracy; h omega at most 1.573 for three forces, so where stability binds "
      "velocity Verlet goes further. Spring damping lowers its order to 3 and ends the conservation of angular "
      "momentum";
  return info;
}

}  // namespace

Coefficients yoshida4Fractions() {
  const long double g = 1.0L / (2.0L - std::cbrt(2.0L));
  return {g, 1.0L - 2.0L * g, g};
}

std::unique_ptr<Integrator> yoshida4() { return std::make_unique<Composition>(yoshida4Info(), yoshida4Fractions()); }

}  // namespace muelle::engine
