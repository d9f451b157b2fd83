#pragma once
/// \file
/// Springs of general topology on padded nodes. Forces are added one spring after another in the order of the arrays,
/// so the sums do not depend on the width of the registers; that neighbours in the arrays have no node in common makes
/// it fast, and is not needed for it to be right.

#include "engine/kernels/kernel_arguments.h"
#include "engine/kernels/loops/spring_force.h"

namespace muelle::engine::kernels {
namespace {

template <int D>
inline constexpr int lanesOfNode = D == 3 ? 4 : D;

template <int D, bool relative, bool projected>
void addOneSpring(SpringArrays s, std::size_t i, const double* x, const double* v, double* f) {
  double d[D], w[D] = {}, F[D];
  for (int c = 0; c < D; ++c) d[c] = x[s.a[i] + c] - x[s.b[i] + c];
  if constexpr (relative || projected) {
    for (int c = 0; c < D; ++c) w[c] = v[s.a[i] + c] - v[s.b[i] + c];
  }
  const Material m = {s.k[i], s.L0[i], relative ? s.dRelative[i] : 0.0, projected ? s.dProjected[i] : 0.0};
  springForce<D, relative, projected>(d, w, m, F);
  for (int c = 0; c < D; ++c) f[s.a[i] + c] += F[c];
  for (int c = 0; c < D; ++c) f[s.b[i] + c] -= F[c];
}

template <class Lanes, int D, bool relative, bool projected>
void addSprings(const SpringArrays& springs, const double* x, const double* v, double* f) {
  const SpringArrays s = springs;  // a store could change what a reference leads to, as far as the compiler knows
  using Vector = typename Lanes::Vector;
  constexpr std::size_t width = Lanes::width;
  std::size_t i = 0;
  for (; i + width <= s.count; i += width) {
    Vector d[D], w[D];
    Lanes::template differences<D>(x, s.a + i, s.b + i, d);
    Vector square = d[0] * d[0];
    for (int c = 1; c < D; ++c) square += d[c] * d[c];
    const Vector L = Lanes::root(square);
    Vector ratio = Lanes::load(s.k + i) * (Lanes::load(s.L0 + i) - L);
    if constexpr (relative || projected) Lanes::template differences<D>(v, s.a + i, s.b + i, w);
    if constexpr (projected) {
      Vector speed = w[0] * d[0];
      for (int c = 1; c < D; ++c) speed += w[c] * d[c];
      const Vector inverse = Lanes::all(1.0) / L;
      ratio = (ratio - Lanes::load(s.dProjected + i) * (speed * inverse)) * inverse;
    } else {
      ratio = ratio / L;
    }
    if (__builtin_expect(!Lanes::allWithin(square, smallestSquare, ratio, largestRatio), 0)) {
      for (std::size_t j = i; j < i + width; ++j) addOneSpring<D, relative, projected>(s, j, x, v, f);
      continue;
    }
    for (int c = 0; c < D; ++c) d[c] *= ratio;
    if constexpr (relative) {
      const Vector coefficient = Lanes::load(s.dRelative + i);
      for (int c = 0; c < D; ++c) d[c] -= coefficient * w[c];
    }
    Lanes::template scatter<D>(d, f, s.a + i, s.b + i);
  }
  for (; i < s.count; ++i) addOneSpring<D, relative, projected>(s, i, x, v, f);
}

/// In 1D there is neither root nor division, and nothing for registers to win.
template <bool relative>
void addSpringsOfLine(const SpringArrays& s, const double* x, const double* v, double* f) {
  for (std::size_t i = 0; i < s.count; ++i) addOneSpring<1, relative, false>(s, i, x, v, f);
}

}  // namespace
}  // namespace muelle::engine::kernels
