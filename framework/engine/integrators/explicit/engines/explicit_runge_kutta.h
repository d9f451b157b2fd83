#pragma once
#include "engine/integrators/explicit/engines/stage_integrator.h"

namespace muelle::engine {

/// Explicit Runge-Kutta methods.
class ExplicitRungeKutta : public StageIntegrator {
 public:
  /// \param more weights of a second error estimate; may be empty
  ExplicitRungeKutta(MethodInfo info, const ButcherTableau& tableau, const Coefficients& more = {})
      : StageIntegrator(std::move(info), accelerationTableau(tableau, more)) {}
};

}  // namespace muelle::engine
