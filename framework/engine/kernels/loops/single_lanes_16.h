#pragma once
/// \file
/// Sixteen springs at a time in single precision: AVX-512, along arrays.

#include "engine/kernels/loops/lanes_8.h"
#include "engine/kernels/loops/single_lanes_8.h"

#include <cstdint>

namespace muelle::engine::kernels {
namespace {

struct SingleLanes16 {
  using Vector = float __attribute__((vector_size(64)));
  static constexpr std::size_t width = 16;

  static Vector load(const float* p) { return _mm512_loadu_ps(p); }
  static void store(float* p, Vector v) { _mm512_storeu_ps(p, v); }
  static Vector all(float value) { return _mm512_set1_ps(value); }

  static Vector root(Vector a) { return _mm512_sqrt_ps(a); }
  static Vector whereNotZero(Vector condition, Vector value) {
    return _mm512_maskz_mov_ps(_mm512_cmp_ps_mask(condition, _mm512_setzero_ps(), _CMP_NEQ_UQ), value);
  }

  /// a - b of integers along an array.
  static Vector difference(const std::int32_t* a, const std::int32_t* b) {
    return _mm512_cvtepi32_ps(_mm512_sub_epi32(_mm512_loadu_si512(a), _mm512_loadu_si512(b)));
  }
};

/// The same as eight lanes, whose sums become eight doubles in one register.
struct SingleLanes8Of16 : SingleLanes8 {
  static Eight widened(Vector a, int /*half*/) { return _mm512_cvtps_pd(a); }
};

}  // namespace
}  // namespace muelle::engine::kernels
