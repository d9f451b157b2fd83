#pragma once
/// \file
/// Springs i -> i + stride on nodes in planes: nothing is gathered and nothing is scattered.

#include "engine/kernels/kernel_arguments.h"
#include "engine/kernels/loops/spring_force.h"

namespace muelle::engine::kernels {
namespace {

template <int D, bool relative, bool projected, bool constant>
void forceOfOne(const RunArrays& run, const PlanarState& at, std::size_t i, std::size_t out, const Planes& force) {
  double d[D], w[D] = {}, F[D];
  for (std::size_t c = 0; c < D; ++c) d[c] = at.x[c * at.plane + i] - at.x[c * at.plane + i + run.stride];
  if constexpr (relative || projected) {
    for (std::size_t c = 0; c < D; ++c) w[c] = at.v[c * at.plane + i] - at.v[c * at.plane + i + run.stride];
  }
  const std::size_t j = constant ? 0 : i - run.first;
  const Material m = {run.k[j], run.L0[j], relative ? run.dRelative[j] : 0.0, projected ? run.dProjected[j] : 0.0};
  springForce<D, relative, projected>(d, w, m, F);
  for (std::size_t c = 0; c < D; ++c) force.data[c * force.plane + out] = F[c];
}

/// A coefficient of the material: one register for all, or one read a step.
template <class Lanes, bool constant>
inline typename Lanes::Vector coefficient(const double* values, std::size_t j) {
  return constant ? Lanes::all(values[0]) : Lanes::load(values + j);
}

/// Writes the forces on the nodes i in [begin, end) by their springs; that of `begin` goes to entry 0.
template <class Lanes, int D, bool relative, bool projected, bool constant>
void forceOfRun(const RunArrays& run, const PlanarState& at, std::size_t begin, std::size_t end, const Planes& force) {
  using Vector = typename Lanes::Vector;
  constexpr std::size_t width = Lanes::width;
  std::size_t i = begin;
  for (; i + width <= end; i += width) {
    Vector d[D], w[D];
    const std::size_t j = constant ? 0 : i - run.first;
    for (std::size_t c = 0; c < D; ++c) {
      const double* x = at.x + c * at.plane + i;
      d[c] = Lanes::load(x) - Lanes::load(x + run.stride);
    }
    if constexpr (relative || projected) {
      for (std::size_t c = 0; c < D; ++c) {
        const double* v = at.v + c * at.plane + i;
        w[c] = Lanes::load(v) - Lanes::load(v + run.stride);
      }
    }
    const Vector k = coefficient<Lanes, constant>(run.k, j), L0 = coefficient<Lanes, constant>(run.L0, j);
    if constexpr (D == 1) {
      d[0] = Lanes::withSign(k * (L0 - Lanes::magnitude(d[0])), d[0]);
    } else {
      Vector square = d[0] * d[0];
      for (int c = 1; c < D; ++c) square += d[c] * d[c];
      const Vector L = Lanes::root(square);
      Vector ratio = k * (L0 - L);
      if constexpr (projected) {
        Vector speed = w[0] * d[0];
        for (int c = 1; c < D; ++c) speed += w[c] * d[c];
        const Vector inverse = Lanes::all(1.0) / L;
        ratio = (ratio - coefficient<Lanes, constant>(run.dProjected, j) * (speed * inverse)) * inverse;
      } else {
        ratio = ratio / L;
      }
      if (__builtin_expect(!Lanes::allWithin(square, smallestSquare, ratio, largestRatio), 0)) {
        for (std::size_t one = i; one < i + width; ++one) {
          forceOfOne<D, relative, projected, constant>(run, at, one, one - begin, force);
        }
        continue;
      }
      for (int c = 0; c < D; ++c) d[c] *= ratio;
    }
    if constexpr (relative) {
      const Vector damping = coefficient<Lanes, constant>(run.dRelative, j);
      for (int c = 0; c < D; ++c) d[c] -= damping * w[c];
    }
    for (std::size_t c = 0; c < D; ++c) Lanes::store(force.data + c * force.plane + (i - begin), d[c]);
  }
  for (; i < end; ++i) forceOfOne<D, relative, projected, constant>(run, at, i, i - begin, force);
}

}  // namespace
}  // namespace muelle::engine::kernels
