#pragma once
/// \file
/// Eight springs or nodes at a time: AVX-512. Springs of general topology go by four there, too: with eight, more
/// registers are taken apart and put together than are saved.

#include <immintrin.h>
#include <cstddef>
#include <cstdint>

namespace muelle::engine::kernels {
namespace {

using Eight = double __attribute__((vector_size(64)));
using LooseEight __attribute__((aligned(8), may_alias)) = Eight;

struct Lanes8 {
  using Vector = Eight;
  static constexpr std::size_t width = 8;

  static Vector load(const double* p) { return *reinterpret_cast<const LooseEight*>(p); }
  static void store(double* p, Vector v) { *reinterpret_cast<LooseEight*>(p) = v; }
  static Vector all(double value) { return _mm512_set1_pd(value); }

  static Vector root(Vector a) { return _mm512_sqrt_pd(a); }
  static Vector magnitude(Vector a) { return _mm512_andnot_pd(all(-0.0), a); }
  static __mmask8 isNotZero(Vector a) { return _mm512_cmp_pd_mask(a, Vector{}, _CMP_NEQ_UQ); }
  /// `value`, with its sign turned where `sign` is below 0, and 0 where that is 0.
  static Vector withSign(Vector value, Vector sign) {
    return _mm512_maskz_xor_pd(isNotZero(sign), value, _mm512_and_pd(sign, all(-0.0)));
  }
  static Vector whereNotZero(Vector condition, Vector value) {
    return _mm512_maskz_mov_pd(isNotZero(condition), value);
  }
  static Vector largerOfZeroAnd(Vector a) {
    return _mm512_maskz_mov_pd(_mm512_cmp_pd_mask(a, Vector{}, _CMP_GT_OQ), a);
  }

  /// Whether all a > low and |b| < high.
  static bool allWithin(Vector a, double low, Vector b, double high) {
    const __mmask8 aboveLow = _mm512_cmp_pd_mask(a, all(low), _CMP_GT_OQ);
    return _mm512_mask_cmp_pd_mask(aboveLow, magnitude(b), all(high), _CMP_LT_OQ) == 0xFF;
  }
  /// a where it is larger than b, else b.
  static Vector larger(Vector b, Vector a) { return _mm512_max_pd(a, b); }
  /// Nearest integers, of two the even one.
  static void storeRounded(std::int32_t* p, Vector v) {
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(p), _mm512_cvtpd_epi32(v));
  }
  static bool anyPositive(Vector a) { return _mm512_cmp_pd_mask(a, Vector{}, _CMP_GT_OQ) != 0; }
};

}  // namespace
}  // namespace muelle::engine::kernels
