#include "engine/integrators/explicit/engines/drag_factors.h"

#include <cmath>

namespace muelle::engine {

void DragFactors::update(const Drag& drag, std::span<const double> mass, double h) {
  if (h == h_ && factors_.size() == mass.size()) return;
  h_ = h;
  factors_.resize(mass.size());
  const std::span<const double> d = drag.coefficients();
  for (std::size_t i = 0; i < mass.size(); ++i) {
    const double c = mass[i] > 0.0 ? h * d[i] / mass[i] : 0.0;
    Factors& f = factors_[i];
    f.decay = std::exp(-c);
    f.loss = std::expm1(-c);
    f.phi1 = c == 0.0 ? 1.0 : -f.loss / c;
    // (1 - phi1)/c cancels for small c: its series, whose first term left out is below round-off at the switch.
    f.phi2 =
        std::abs(c) < 0.05
            ? 0.5 - c * (1.0 / 6.0 -
                         c * (1.0 / 24.0 -
                              c * (1.0 / 120.0 -
                                   c * (1.0 / 720.0 - c * (1.0 / 5040.0 - c * (1.0 / 40320.0 - c * (1.0 / 362880.0 -
                                                                                                    c / 3628800.0)))))))
            : (1.0 - f.phi1) / c;
  }
}

}  // namespace muelle::engine
