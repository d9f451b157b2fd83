#pragma once
/// \file
/// A plane that pushes, on nodes of both layouts. Most nodes are far from it: a register of nodes of which none is
/// below the plane costs the products of its gap and no store.

#include "engine/kernels/kernel_arguments.h"

namespace muelle::engine::kernels {
namespace {

/// N [N], 0 where it does not push. \param depth [m] below the plane
template <class Lanes>
inline typename Lanes::Vector normalForce(const PlaneObstacle& plane, typename Lanes::Vector depth,
                                          typename Lanes::Vector rate) {
  const typename Lanes::Vector N = Lanes::all(plane.k) * depth - Lanes::all(plane.d) * rate;
  // Not below the plane: the depth is made 0 first, then N where that is 0.
  return Lanes::whereNotZero(Lanes::largerOfZeroAnd(depth), Lanes::largerOfZeroAnd(N));
}

template <int D>
void contactOfOne(const PlaneObstacle& plane, const double* x, const double* v, const double* inverseMass, double* out,
                  std::size_t step) {
  double depth = (plane.point[0] - x[0]) * plane.normal[0], rate = (v[0] - plane.velocity[0]) * plane.normal[0];
  for (std::size_t c = 1; c < D; ++c) {
    depth += (plane.point[c] - x[c * step]) * plane.normal[c];
    rate += (v[c * step] - plane.velocity[c]) * plane.normal[c];
  }
  if (!(depth > 0.0)) return;
  const double N = plane.k * depth - plane.d * rate;
  if (!(N > 0.0)) return;
  for (std::size_t c = 0; c < D; ++c) {
    const double F = N * plane.normal[c];
    out[c * step] += inverseMass ? F * *inverseMass : F;
  }
}

template <int D>
void paddedContact(const PlaneObstacle& plane, const PaddedContactArrays& arrays) {
  constexpr std::size_t ofNode = D == 3 ? 4 : D;
  for (std::size_t i = 0; i < arrays.nodes; ++i) {
    const std::size_t at = ofNode * i;
    const double* inverse = arrays.inverseMass ? arrays.inverseMass + at : nullptr;
    contactOfOne<D>(plane, arrays.x + at, arrays.v + at, inverse, arrays.out + at, 1);
  }
}

template <class Lanes, int D>
void planarContact(const PlaneObstacle& plane, const PlanarContactArrays& arrays) {
  using Vector = typename Lanes::Vector;
  std::size_t i = 0;
  for (; i + Lanes::width <= arrays.nodes; i += Lanes::width) {
    Vector depth = (Lanes::all(plane.point[0]) - Lanes::load(arrays.x + i)) * Lanes::all(plane.normal[0]);
    for (std::size_t c = 1; c < D; ++c) {
      depth +=
          (Lanes::all(plane.point[c]) - Lanes::load(arrays.x + c * arrays.plane + i)) * Lanes::all(plane.normal[c]);
    }
    if (!Lanes::anyPositive(depth)) continue;
    Vector rate = (Lanes::load(arrays.v + i) - Lanes::all(plane.velocity[0])) * Lanes::all(plane.normal[0]);
    for (std::size_t c = 1; c < D; ++c) {
      rate +=
          (Lanes::load(arrays.v + c * arrays.plane + i) - Lanes::all(plane.velocity[c])) * Lanes::all(plane.normal[c]);
    }
    const Vector N = normalForce<Lanes>(plane, depth, rate);
    for (std::size_t c = 0; c < D; ++c) {
      double* out = arrays.out + c * arrays.plane + i;
      Vector F = N * Lanes::all(plane.normal[c]);
      if (arrays.inverseMass) F *= Lanes::load(arrays.inverseMass + i);
      Lanes::store(out, Lanes::load(out) + F);
    }
  }
  for (; i < arrays.nodes; ++i) {
    const double* inverse = arrays.inverseMass ? arrays.inverseMass + i : nullptr;
    contactOfOne<D>(plane, arrays.x + i, arrays.v + i, inverse, arrays.out + i, arrays.plane);
  }
}

}  // namespace
}  // namespace muelle::engine::kernels
