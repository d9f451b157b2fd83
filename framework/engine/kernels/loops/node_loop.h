#pragma once
/// \file
/// From sums of forces to accelerations (or forces), for both layouts.

#include "engine/kernels/kernel_arguments.h"

namespace muelle::engine::kernels {
namespace {

/// What becomes of the sum of spring forces on the nodes [i, i + width), component c.
template <class Lanes>
inline void finishPlanar(const PlanarFinish& finish, std::size_t c, std::size_t i, typename Lanes::Vector F) {
  const std::size_t at = c * finish.plane + i;
  if (finish.added) F = Lanes::load(finish.added + at) + F;
  if (finish.drag) F -= Lanes::load(finish.drag + i) * Lanes::load(finish.v + at);
  if (finish.inverseMass) {
    const typename Lanes::Vector inverse = Lanes::load(finish.inverseMass + i);
    F = F * inverse + Lanes::whereNotZero(inverse, Lanes::all(finish.gravity[c]));
  } else if (finish.mass) {
    F += Lanes::load(finish.mass + i) * Lanes::all(finish.gravity[c]);
  }
  Lanes::store(finish.out + at, F);
}

/// Sums over the runs, for the nodes [begin, end): end - begin is a multiple of 8.
template <class Lanes, int D>
void planarPass(const NodeSums& nodeSums, const PlanarFinish& planarFinish, std::size_t begin, std::size_t end) {
  const NodeSums sums = nodeSums;  // a store could change what a reference leads to, as far as the compiler knows
  const PlanarFinish finish = planarFinish;
  using Vector = typename Lanes::Vector;
  constexpr std::size_t width = Lanes::width, together = width == 8 ? 1 : 8 / width;
  for (std::size_t c = 0; c < D; ++c) {
    for (std::size_t i = 0; i < end - begin; i += 8) {
      Vector F[together] = {};
      for (std::size_t r = 0; r < sums.runs; ++r) {
        const double* own = sums.own[r] + c * sums.planes[r] + i;
        const double* past = sums.past[r] + c * sums.planes[r] + i;
        for (std::size_t t = 0; t < together; ++t) {
          F[t] += Lanes::load(own + t * width);
          F[t] -= Lanes::load(past + t * width);
        }
      }
      for (std::size_t t = 0; t < together; ++t) finishPlanar<Lanes>(finish, c, begin + i + t * width, F[t]);
    }
  }
}

/// Lanes of padded nodes, a multiple of the lanes of a node.
template <class Lanes, int D>
void paddedPass(const PaddedFinish& paddedFinish, std::size_t lanes) {
  const PaddedFinish finish = paddedFinish;
  using Vector = typename Lanes::Vector;
  constexpr std::size_t width = Lanes::width;
  constexpr std::size_t ofNode = D == 3 ? 4 : D;
  double pattern[8] = {};
  for (std::size_t i = 0; i < 8; ++i) pattern[i] = i % ofNode < D ? finish.gravity[i % ofNode] : 0.0;
  std::size_t i = 0;
  for (; i + 8 <= lanes; i += 8) {
    for (std::size_t t = 0; t < 8; t += width) {
      Vector F = Lanes::load(finish.f + i + t);
      if (finish.drag) F -= Lanes::load(finish.drag + i + t) * Lanes::load(finish.v + i + t);
      const Vector inverse = Lanes::load(finish.inverseMass + i + t);
      Lanes::store(finish.out + i + t, F * inverse + Lanes::whereNotZero(inverse, Lanes::load(pattern + t)));
    }
  }
  for (; i < lanes; ++i) {
    double F = finish.f[i];
    if (finish.drag) F -= finish.drag[i] * finish.v[i];
    const double inverse = finish.inverseMass[i];
    finish.out[i] = F * inverse + (inverse != 0.0 ? pattern[i % 8] : 0.0);
  }
}

}  // namespace
}  // namespace muelle::engine::kernels
