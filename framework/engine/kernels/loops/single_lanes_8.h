#pragma once
/// \file
/// Eight springs or nodes at a time in single precision: AVX2.

#include "engine/kernels/loops/lanes_4.h"

#include <cstdint>

namespace muelle::engine::kernels {
namespace {

struct SingleLanes8 {
  using Vector = float __attribute__((vector_size(32)));
  static constexpr std::size_t width = 8;

  static Vector load(const float* p) { return _mm256_loadu_ps(p); }
  static void store(float* p, Vector v) { _mm256_storeu_ps(p, v); }
  static Vector all(float value) { return _mm256_set1_ps(value); }

  static Vector root(Vector a) { return _mm256_sqrt_ps(a); }
  static Vector whereNotZero(Vector condition, Vector value) {
    return _mm256_and_ps(value, _mm256_cmp_ps(condition, _mm256_setzero_ps(), _CMP_NEQ_UQ));
  }

  /// a - b of integers along an array.
  static Vector difference(const std::int32_t* a, const std::int32_t* b) {
    return _mm256_cvtepi32_ps(_mm256_sub_epi32(_mm256_loadu_si256(reinterpret_cast<const __m256i*>(a)),
                                               _mm256_loadu_si256(reinterpret_cast<const __m256i*>(b))));
  }

  /// Four nodes' sums of forces as doubles: half 0 or 1.
  static Four widened(Vector a, int half) {
    return _mm256_cvtps_pd(half == 0 ? _mm256_castps256_ps128(a) : _mm256_extractf128_ps(a, 1));
  }
};

}  // namespace
}  // namespace muelle::engine::kernels
