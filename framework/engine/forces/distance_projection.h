#pragma once
#include "engine/constraint_sweep.h"

#include <cstddef>

namespace muelle::engine {

/// What ConstraintProjection does, of a distance between two nodes of one mass each: C = l - L0 with the gradient n at
/// the first node and -n at the other. The sweep over springs waits for each before it can begin the next, so what it
/// computes stays in registers. (Correction times 1/h, where the general one divides: another rounding.)
/// \param a, b first lanes   \param next lanes from a component to the next   \param n D numbers   \param C [m]
/// \param k [N/m]   \param d projected damping [kg/s]
template <int D>
[[gnu::always_inline]] inline void projectDistance(const ConstraintProjection& p, int a, int b, std::ptrdiff_t next,
                                                   const double* n, double C, double k, double d) {
  const double ma = p.inverseMass[a], mb = p.inverseMass[b], stiffness = p.h * p.h * k, damping = p.h * d;
  double square = 0.0, moved = 0.0;
  for (int c = 0; c < D; ++c) square += n[c] * n[c];
  if (d > 0.0) {
    for (int c = 0; c < D; ++c) {
      if (ma > 0.0) moved += n[c] * (p.x[a + c * next] - p.before[a + c * next]);
      if (mb > 0.0) moved -= n[c] * (p.x[b + c * next] - p.before[b + c * next]);
    }
  }
  const double w = square * (ma + mb);
  const double multiplier = -(stiffness * C + damping * moved) / ((stiffness + damping) * w + 1.0);
  const double perH = 1.0 / p.h;
  for (int c = 0; c < D; ++c) {
    const double onA = multiplier * ma * n[c], onB = -multiplier * mb * n[c];
    p.x[a + c * next] += onA;
    p.v[a + c * next] += onA * perH;
    p.x[b + c * next] += onB;
    p.v[b + c * next] += onB * perH;
  }
}

}  // namespace muelle::engine
