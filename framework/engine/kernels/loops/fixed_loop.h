#pragma once
/// \file
/// From doubles to integers of a unit, and from sums in single precision to doubles: once a node, before and after the
/// loops over springs in single precision.

#include "engine/kernels/kernel_arguments.h"
#include "engine/kernels/loops/node_loop.h"

namespace muelle::engine::kernels {
namespace {

/// See Kernels::toFixed. What is no finite number makes 0 x none, which stays in a sum.
template <class Lanes>
double toFixed(const double* values, double first, double perUnit, std::size_t count, std::int32_t* fixed) {
  using Vector = typename Lanes::Vector;
  constexpr std::size_t width = Lanes::width, together = 8 / width;
  Vector far[together], strange[together];
  for (std::size_t t = 0; t < together; ++t) far[t] = strange[t] = Lanes::all(0.0);
  std::size_t i = 0;
  for (; i + 8 <= count; i += 8) {
    for (std::size_t t = 0; t < together; ++t) {
      const Vector from = Lanes::load(values + i + t * width) - Lanes::all(first);
      Lanes::storeRounded(fixed + i + t * width, from * Lanes::all(perUnit));
      far[t] = Lanes::larger(far[t], Lanes::magnitude(from));
      strange[t] += Lanes::all(0.0) * from;
    }
  }
  double largest = 0.0, sum = 0.0, lanes[width];
  for (std::size_t t = 0; t < together; ++t) {
    Lanes::store(lanes, far[t]);
    for (const double lane : lanes) largest = lane > largest ? lane : largest;
    Lanes::store(lanes, strange[t]);
    for (const double lane : lanes) sum += lane;
  }
  for (; i < count; ++i) {
    const double from = values[i] - first, size = __builtin_fabs(from), units = __builtin_rint(from * perUnit);
    fixed[i] = __builtin_fabs(units) < 2147483648.0 ? static_cast<std::int32_t>(units) : 0;  // else of no use anyway
    largest = size > largest ? size : largest;
    sum += 0.0 * from;
  }
  return largest + sum;
}

/// planarPass() of sums in single precision. \tparam Lanes of the doubles that half a register of sums becomes, or all
template <class Single, class Lanes, int D>
void planarPassSingle(const SingleNodeSums& nodeSums, const PlanarFinish& planarFinish, std::size_t begin,
                      std::size_t end) {
  const SingleNodeSums sums = nodeSums;
  const PlanarFinish finish = planarFinish;
  constexpr std::size_t width = Single::width, halves = width / Lanes::width;
  for (std::size_t c = 0; c < D; ++c) {
    for (std::size_t i = 0; i < end - begin; i += width) {
      typename Single::Vector F = {};
      for (std::size_t r = 0; r < sums.runs; ++r) {
        F += Single::load(sums.own[r] + c * sums.planes[r] + i);
        F -= Single::load(sums.past[r] + c * sums.planes[r] + i);
      }
      for (std::size_t half = 0; half < halves; ++half) {
        finishPlanar<Lanes>(finish, c, begin + i + half * Lanes::width, Single::widened(F, static_cast<int>(half)));
      }
    }
  }
}

}  // namespace
}  // namespace muelle::engine::kernels
