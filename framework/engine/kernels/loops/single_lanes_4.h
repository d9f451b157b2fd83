#pragma once
/// \file
/// Four springs or nodes at a time in single precision: registers of 16 bytes, which every processor has or the
/// compiler makes.

#include "engine/kernels/loops/lanes_2.h"

#include <cstdint>

namespace muelle::engine::kernels {
namespace {

using FourSingles = float __attribute__((vector_size(16)));
using FourIntegers = std::int32_t __attribute__((vector_size(16)));
using LooseFourSingles __attribute__((aligned(4), may_alias)) = FourSingles;
using FourUnsigned = std::uint32_t __attribute__((vector_size(16)));
using LooseFourUnsigned __attribute__((aligned(4), may_alias)) = FourUnsigned;

struct SingleLanes4 {
  using Vector = FourSingles;
  static constexpr std::size_t width = 4;

  static Vector load(const float* p) { return *reinterpret_cast<const LooseFourSingles*>(p); }
  static void store(float* p, Vector v) { *reinterpret_cast<LooseFourSingles*>(p) = v; }
  static Vector all(float value) { return Vector{value, value, value, value}; }

  static Vector root(Vector a) {
#if defined(__SSE2__)
    return reinterpret_cast<Vector>(_mm_sqrt_ps(reinterpret_cast<__m128>(a)));
#else
    return Vector{__builtin_sqrtf(a[0]), __builtin_sqrtf(a[1]), __builtin_sqrtf(a[2]), __builtin_sqrtf(a[3])};
#endif
  }
  static Vector whereNotZero(Vector condition, Vector value) {
    return reinterpret_cast<Vector>(reinterpret_cast<FourIntegers>(value) & (condition != 0.0F));
  }

  /// a - b of integers along an array; modulo 2^32 where they are of a unit that is to be replaced.
  static Vector difference(const std::int32_t* a, const std::int32_t* b) {
    const FourUnsigned apart =
        *reinterpret_cast<const LooseFourUnsigned*>(a) - *reinterpret_cast<const LooseFourUnsigned*>(b);
    return __builtin_convertvector(reinterpret_cast<FourIntegers>(apart), Vector);
  }

  /// Two nodes' sums of forces as doubles: half 0 or 1.
  static Two widened(Vector a, int half) {
    return half == 0 ? Two{static_cast<double>(a[0]), static_cast<double>(a[1])}
                     : Two{static_cast<double>(a[2]), static_cast<double>(a[3])};
  }
};

}  // namespace
}  // namespace muelle::engine::kernels
