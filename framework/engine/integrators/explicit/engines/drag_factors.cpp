#include "engine/integrators/explicit/engines/drag_factors.h"

#include <cmath>

namespace muelle::engine {

void DragFactors::update(const DynamicalSystem& system, double h) {
  const std::span<const double> w = system.inverseMass();
  if (h == h_ && factors_.size() == w.size()) return;
  h_ = h;
  factors_.resize(w.size());
  const std::span<const double> d = system.drag()->coefficients();
  for (std::size_t i = 0; i < w.size(); ++i) {
    const double c = h * d[i] * w[i];
    Factors& f = factors_[i];
    if (i > 0 && d[i] * w[i] == d[i - 1] * w[i - 1]) {
      f = factors_[i - 1];
      continue;
    }
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
