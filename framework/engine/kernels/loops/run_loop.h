#pragma once
/// \file
/// Springs i -> i + stride on nodes in planes: nothing is gathered and nothing is scattered.

#include "engine/kernels/kernel_arguments.h"
#include "engine/kernels/loops/spring_force.h"

namespace muelle::engine::kernels {
namespace {

template <int D, bool relative, bool projected, bool constant>
__attribute__((noinline)) void forceOfOne(const RunArrays& run, const PlanarState& at, std::size_t i, std::size_t out,
                                          const Planes& force) {
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
class Coefficient {
 public:
  /// \param values null where the form has none
  explicit Coefficient(const double* values) : values_(values), all_(Lanes::all(constant && values ? *values : 0.0)) {}
  typename Lanes::Vector at(std::size_t j) const { return constant ? all_ : Lanes::load(values_ + j); }

 private:
  const double* values_;
  typename Lanes::Vector all_;
};

/// Writes the forces on the nodes i in [begin, end) by their springs; that of `begin` goes to entry 0.
template <class Lanes, int D, bool relative, bool projected, bool constant>
void forceOfRun(const RunArrays& run, const PlanarState& at, std::size_t begin, std::size_t end, const Planes& force) {
  using Vector = typename Lanes::Vector;
  constexpr std::size_t width = Lanes::width;
  // In variables of its own: a store could change what a reference leads to, as far as the compiler knows.
  const Coefficient<Lanes, constant> k(run.k), L0(run.L0), dRelative(run.dRelative), dProjected(run.dProjected);
  const std::size_t first = run.first;
  const double *near[D], *far[D], *vNear[D], *vFar[D];
  double* out[D];
  for (std::size_t c = 0; c < D; ++c) {
    near[c] = at.x + c * at.plane;
    far[c] = near[c] + run.stride;
    vNear[c] = at.v + c * at.plane;
    vFar[c] = vNear[c] + run.stride;
    out[c] = force.data + c * force.plane;
  }
  std::size_t i = begin;
  for (; i + width <= end; i += width) {
    Vector d[D], w[D];
    for (std::size_t c = 0; c < D; ++c) d[c] = Lanes::load(near[c] + i) - Lanes::load(far[c] + i);
    if constexpr (relative || projected) {
      for (std::size_t c = 0; c < D; ++c) w[c] = Lanes::load(vNear[c] + i) - Lanes::load(vFar[c] + i);
    }
    if constexpr (D == 1) {
      d[0] = Lanes::withSign(k.at(i - first) * (L0.at(i - first) - Lanes::magnitude(d[0])), d[0]);
    } else {
      Vector square = d[0] * d[0];
      for (int c = 1; c < D; ++c) square += d[c] * d[c];
      const Vector L = Lanes::root(square);
      Vector ratio = k.at(i - first) * (L0.at(i - first) - L);
      if constexpr (projected) {
        Vector speed = w[0] * d[0];
        for (int c = 1; c < D; ++c) speed += w[c] * d[c];
        const Vector inverse = Lanes::all(1.0) / L;
        ratio = (ratio - dProjected.at(i - first) * (speed * inverse)) * inverse;
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
      for (int c = 0; c < D; ++c) d[c] -= dRelative.at(i - first) * w[c];
    }
    for (std::size_t c = 0; c < D; ++c) Lanes::store(out[c] + (i - begin), d[c]);
  }
  for (; i < end; ++i) forceOfOne<D, relative, projected, constant>(run, at, i, i - begin, force);
}

}  // namespace
}  // namespace muelle::engine::kernels
