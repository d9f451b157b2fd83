#pragma once
/// \file
/// Two springs or nodes at a time: registers of two doubles, which every processor has or the compiler makes.

#include <cstddef>
#include <cstdint>
#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace muelle::engine::kernels {
namespace {

using Two = double __attribute__((vector_size(16)));
/// For loads and stores at any address of a double: the attributes stand before the =, else clang drops the first.
/// (memcpy into a vector type is far slower with g++ 12.)
using LooseTwo __attribute__((aligned(8), may_alias)) = Two;
/// For nodes of padded lanes, which begin at a multiple of 16 bytes: an operand of SSE2 may then stand in memory.
using NodeTwo __attribute__((aligned(16), may_alias)) = Two;
using TwoBits = long long __attribute__((vector_size(16)));

struct Lanes2 {
  using Vector = Two;
  static constexpr std::size_t width = 2;

  static Vector load(const double* p) { return *reinterpret_cast<const LooseTwo*>(p); }
  static void store(double* p, Vector v) { *reinterpret_cast<LooseTwo*>(p) = v; }
  static Vector loadNode(const double* p) { return *reinterpret_cast<const NodeTwo*>(p); }
  static void storeNode(double* p, Vector v) { *reinterpret_cast<NodeTwo*>(p) = v; }
  static Vector all(double value) { return Vector{value, value}; }

  static Vector root(Vector a) {
#if defined(__SSE2__)
    return reinterpret_cast<Vector>(_mm_sqrt_pd(reinterpret_cast<__m128d>(a)));
#else
    return Vector{__builtin_sqrt(a[0]), __builtin_sqrt(a[1])};
#endif
  }
  static Vector magnitude(Vector a) {
    const TwoBits mask = {0x7fffffffffffffffLL, 0x7fffffffffffffffLL};
    return reinterpret_cast<Vector>(reinterpret_cast<TwoBits>(a) & mask);
  }
  /// `value`, with its sign turned where `sign` is below 0, and 0 where that is 0.
  static Vector withSign(Vector value, Vector sign) {
    const TwoBits top = {static_cast<long long>(1ULL << 63), static_cast<long long>(1ULL << 63)};
    const TwoBits bits = reinterpret_cast<TwoBits>(value) ^ (reinterpret_cast<TwoBits>(sign) & top);
    return reinterpret_cast<Vector>(bits & (sign != 0.0));
  }
  static Vector whereNotZero(Vector condition, Vector value) {
    return reinterpret_cast<Vector>(reinterpret_cast<TwoBits>(value) & (condition != 0.0));
  }
  static Vector largerOfZeroAnd(Vector a) { return reinterpret_cast<Vector>(reinterpret_cast<TwoBits>(a) & (a > 0.0)); }

  /// Whether all a > low and |b| < high.
  static bool allWithin(Vector a, double low, Vector b, double high) {
#if defined(__SSE2__)
    // Not by the compiler's own comparison, of which g++ 12 takes the bits one by one.
    const __m128d aboveLow = _mm_cmpgt_pd(a, all(low)), belowHigh = _mm_cmplt_pd(magnitude(b), all(high));
    return _mm_movemask_pd(_mm_and_pd(aboveLow, belowHigh)) == 3;
#else
    return a[0] > low && a[1] > low && __builtin_fabs(b[0]) < high && __builtin_fabs(b[1]) < high;
#endif
  }
  /// a where it is larger than b, else b.
  static Vector larger(Vector b, Vector a) { return a > b ? a : b; }
  /// Nearest integers, of two the even one.
  static void storeRounded(std::int32_t* p, Vector v) {
#if defined(__SSE2__)
    _mm_storel_epi64(reinterpret_cast<__m128i*>(p), _mm_cvtpd_epi32(reinterpret_cast<__m128d>(v)));
#else
    p[0] = static_cast<std::int32_t>(__builtin_rint(v[0]));
    p[1] = static_cast<std::int32_t>(__builtin_rint(v[1]));
#endif
  }
  static bool anyPositive(Vector a) {
#if defined(__SSE2__)
    return _mm_movemask_pd(_mm_cmpgt_pd(a, Vector{})) != 0;
#else
    return a[0] > 0.0 || a[1] > 0.0;
#endif
  }

  static Vector firsts(Vector a, Vector b) {
#if defined(__SSE2__)
    return reinterpret_cast<Vector>(_mm_unpacklo_pd(reinterpret_cast<__m128d>(a), reinterpret_cast<__m128d>(b)));
#else
    return Vector{a[0], b[0]};
#endif
  }
  static Vector seconds(Vector a, Vector b) {
#if defined(__SSE2__)
    return reinterpret_cast<Vector>(_mm_unpackhi_pd(reinterpret_cast<__m128d>(a), reinterpret_cast<__m128d>(b)));
#else
    return Vector{a[1], b[1]};
#endif
  }

  /// Components of the differences of padded nodes, d[c] those of all lanes.
  template <int D>
  static void differences(const double* values, const int* a, const int* b, Vector* d) {
    static_assert(D == 2 || D == 3);
    const Vector first = loadNode(values + a[0]) - loadNode(values + b[0]);
    const Vector second = loadNode(values + a[1]) - loadNode(values + b[1]);
    d[0] = firsts(first, second);
    d[1] = seconds(first, second);
    if constexpr (D == 3) {
      d[2] = firsts(loadNode(values + a[0] + 2) - loadNode(values + b[0] + 2),
                    loadNode(values + a[1] + 2) - loadNode(values + b[1] + 2));
    }
  }

  static void addAndSubtract(double* a, double* b, Vector F) {
    storeNode(a, loadNode(a) + F);
    storeNode(b, loadNode(b) - F);
  }

  /// Adds F to the nodes a and subtracts it from the nodes b, one spring after another.
  template <int D>
  static void scatter(const Vector* F, double* f, const int* a, const int* b) {
    // All places before the first store, which could change the lists, as far as the compiler knows.
    double *const a0 = f + a[0], *const b0 = f + b[0], *const a1 = f + a[1], *const b1 = f + b[1];
    addAndSubtract(a0, b0, firsts(F[0], F[1]));
    if constexpr (D == 3) addAndSubtract(a0 + 2, b0 + 2, firsts(F[2], Vector{}));
    addAndSubtract(a1, b1, seconds(F[0], F[1]));
    if constexpr (D == 3) addAndSubtract(a1 + 2, b1 + 2, seconds(F[2], Vector{}));
  }
};

}  // namespace
}  // namespace muelle::engine::kernels
