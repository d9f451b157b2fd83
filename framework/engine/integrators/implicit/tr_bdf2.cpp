#include "engine/integrators/implicit/esdirk.h"
#include "engine/integrators/implicit/methods.h"

#include <cmath>

namespace muelle::engine {

namespace {

MethodInfo trBdf2Info() {
  MethodInfo info = implicitInfo("tr_bdf2", "TR-BDF2", 2, Stability::LStable);
  info.adaptive = true;
  info.formula = "y2 = y0 + d h (f0 + f2),  y1 = y0 + w h (f0 + f2) + d h f1,  d = 1 - 1/sqrt(2),  w = sqrt(2)/4";
  info.source =
      "Bank et al.: Transient Simulation of Silicon Devices and Circuits, 1985; Hosea, Shampine: Analysis and "
      "Implementation of TR-BDF2, 1996";
  info.remark =
      "Trapezoidal rule to 0.586 h, then BDF2 over both parts: two solves a step. Kills fast modes without the memory "
      "of bdf2, and damps slow ones less: by a factor 1 - 0.0037 (h w)^4 a step, where bdf2 has 1 - 0.25 (h w)^4. With "
      "a step as a fixed-step method, with a tolerance at loose ones; below 1e-4 esdirk4 needs fewer solves. "
      "R(z) = (1 + (1 - 2 d) z) / (1 - d z)^2.";
  return info;
}

EsdirkTableau trBdf2Tableau() {
  const double d = 1.0 - std::sqrt(0.5), w = 0.25 * std::sqrt(2.0);
  // The embedded result has order 3: weights (1 - w) / 3, (3 w + 1) / 3, d / 3.
  return {.diagonal = d,
          .a = {{}, {d}, {w, w}},
          .error = {(4.0 * w - 1.0) / 3.0, -1.0 / 3.0, 2.0 * d / 3.0},
          .errorPower = 3};
}

}  // namespace

std::unique_ptr<Integrator> trBdf2() { return std::make_unique<Esdirk>(trBdf2Info(), trBdf2Tableau()); }

}  // namespace muelle::engine
