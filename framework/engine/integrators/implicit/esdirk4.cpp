#include "engine/integrators/implicit/esdirk.h"
#include "engine/integrators/implicit/methods.h"

namespace muelle::engine {

namespace {

MethodInfo esdirk4Info() {
  MethodInfo info = implicitInfo("esdirk4", "ESDIRK 4(3)", 4, Stability::LStable);
  info.adaptive = true;
  info.formula = "y_i = y0 + h sum_j<i a_ij f_j + h f_i / 4,  i = 2 .. 6,  y1 = y_6";
  info.source =
      "Kennedy, Carpenter: Additive Runge-Kutta Schemes for Convection-Diffusion-Reaction Equations, 2003: the "
      "implicit "
      "part of ARK4(3)6L[2]SA";
  info.remark =
      "Five solves a step with one matrix. For stiff scenes that are to be exact: it chooses its steps by the motion, "
      "not by the stiffest spring. Fast modes die, slow ones lose 1 - 2.7e-5 (h w)^6 a step.";
  return info;
}

EsdirkTableau esdirk4Tableau() {
  return {.diagonal = 0.25,
          .a = {{},
                {1.0 / 4},
                {8611.0 / 62500, -1743.0 / 31250},
                {5012029.0 / 34652500, -654441.0 / 2922500, 174375.0 / 388108},
                {15267082809.0 / 155376265600, -71443401.0 / 120774400, 730878875.0 / 902184768, 2285395.0 / 8070912},
                {82889.0 / 524892, 0.0, 15625.0 / 83664, 69875.0 / 102672, -2260.0 / 8211}},
          .error = {31666707.0 / 9881966720, 0.0, -256875.0 / 105007616, -2768025.0 / 128864768, 169839.0 / 3864644,
                    -5247.0 / 225920},
          .errorPower = 4};
}

}  // namespace

std::unique_ptr<Integrator> esdirk4() { return std::make_unique<Esdirk>(esdirk4Info(), esdirk4Tableau()); }

}  // namespace muelle::engine
