#pragma once
/// \file
/// Four springs or nodes at a time: AVX2.

#include <immintrin.h>
#include <cstddef>
#include <cstdint>

namespace muelle::engine::kernels {
namespace {

using Four = double __attribute__((vector_size(32)));
using LooseFour __attribute__((aligned(8), may_alias)) = Four;

struct Lanes4 {
  using Vector = Four;
  static constexpr std::size_t width = 4;

  static Vector load(const double* p) { return *reinterpret_cast<const LooseFour*>(p); }
  static void store(double* p, Vector v) { *reinterpret_cast<LooseFour*>(p) = v; }
  static Vector all(double value) { return Vector{value, value, value, value}; }

  static Vector root(Vector a) { return _mm256_sqrt_pd(a); }
  static Vector magnitude(Vector a) { return _mm256_andnot_pd(all(-0.0), a); }
  static Vector isNotZero(Vector a) { return _mm256_cmp_pd(a, Vector{}, _CMP_NEQ_UQ); }
  /// `value`, with its sign turned where `sign` is below 0, and 0 where that is 0.
  static Vector withSign(Vector value, Vector sign) {
    return _mm256_and_pd(_mm256_xor_pd(value, _mm256_and_pd(sign, all(-0.0))), isNotZero(sign));
  }
  static Vector whereNotZero(Vector condition, Vector value) { return _mm256_and_pd(value, isNotZero(condition)); }
  static Vector largerOfZeroAnd(Vector a) { return _mm256_and_pd(a, _mm256_cmp_pd(a, Vector{}, _CMP_GT_OQ)); }

  /// Whether all a > low and |b| < high.
  static bool allWithin(Vector a, double low, Vector b, double high) {
    const Vector aboveLow = _mm256_cmp_pd(a, all(low), _CMP_GT_OQ);
    const Vector belowHigh = _mm256_cmp_pd(magnitude(b), all(high), _CMP_LT_OQ);
    return _mm256_movemask_pd(_mm256_and_pd(aboveLow, belowHigh)) == 0xF;
  }
  /// a where it is larger than b, else b.
  static Vector larger(Vector b, Vector a) { return _mm256_max_pd(a, b); }
  /// Nearest integers, of two the even one.
  static void storeRounded(std::int32_t* p, Vector v) {
    _mm_storeu_si128(reinterpret_cast<__m128i*>(p), _mm256_cvtpd_epi32(v));
  }
  static bool anyPositive(Vector a) { return _mm256_movemask_pd(_mm256_cmp_pd(a, Vector{}, _CMP_GT_OQ)) != 0; }

  /// Components of the differences of padded nodes, d[c] those of all lanes.
  template <int D>
  static void differences(const double* values, const int* a, const int* b, Vector* d) {
    static_assert(D == 3);
    const Vector d0 = load(values + a[0]) - load(values + b[0]), d1 = load(values + a[1]) - load(values + b[1]);
    const Vector d2 = load(values + a[2]) - load(values + b[2]), d3 = load(values + a[3]) - load(values + b[3]);
    const Vector even01 = _mm256_unpacklo_pd(d0, d1), odd01 = _mm256_unpackhi_pd(d0, d1);
    const Vector even23 = _mm256_unpacklo_pd(d2, d3), odd23 = _mm256_unpackhi_pd(d2, d3);
    d[0] = _mm256_permute2f128_pd(even01, even23, 0x20);
    d[1] = _mm256_permute2f128_pd(odd01, odd23, 0x20);
    d[2] = _mm256_permute2f128_pd(even01, even23, 0x31);
  }

  static void addAndSubtract(double* a, double* b, Vector F) {
    store(a, load(a) + F);
    store(b, load(b) - F);
  }

  /// Adds F to the nodes a and subtracts it from the nodes b, one spring after another.
  template <int D>
  static void scatter(const Vector* F, double* f, const int* a, const int* b) {
    static_assert(D == 3);
    const Vector even = _mm256_unpacklo_pd(F[0], F[1]), odd = _mm256_unpackhi_pd(F[0], F[1]);
    const Vector evenZ = _mm256_unpacklo_pd(F[2], Vector{}), oddZ = _mm256_unpackhi_pd(F[2], Vector{});
    // All places before the first store, which could change the lists, as far as the compiler knows.
    double *const a0 = f + a[0], *const b0 = f + b[0], *const a1 = f + a[1], *const b1 = f + b[1];
    double *const a2 = f + a[2], *const b2 = f + b[2], *const a3 = f + a[3], *const b3 = f + b[3];
    addAndSubtract(a0, b0, _mm256_permute2f128_pd(even, evenZ, 0x20));
    addAndSubtract(a1, b1, _mm256_permute2f128_pd(odd, oddZ, 0x20));
    addAndSubtract(a2, b2, _mm256_permute2f128_pd(even, evenZ, 0x31));
    addAndSubtract(a3, b3, _mm256_permute2f128_pd(odd, oddZ, 0x31));
  }
};

}  // namespace
}  // namespace muelle::engine::kernels
