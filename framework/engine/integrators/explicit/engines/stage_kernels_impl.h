/// \file
/// The kernels of stage_kernels.h for one instruction set: included once by each of the sources that are compiled for
/// one, which defines MUELLE_LANES (doubles in a register) and MUELLE_KERNELS (a name). No inline function of another
/// header may be called here: the linker could take this file's copy for all.

#include "engine/integrators/explicit/engines/stage_kernels.h"

#include <utility>

/// The bodies of loops are lambdas, which are too long for the compiler to take in by itself.
#define MUELLE_INLINE __attribute__((always_inline))

namespace muelle::engine {

namespace {

using Vector = double __attribute__((vector_size(8 * MUELLE_LANES), aligned(8), may_alias));

/// A register of lanes, and a single one.
struct Wide {
  static constexpr std::size_t lanes = MUELLE_LANES;
  Vector value;
  MUELLE_INLINE static Wide load(const double* p) { return {*reinterpret_cast<const Vector*>(p)}; }
  void store(double* p) const { *reinterpret_cast<Vector*>(p) = value; }
};
struct One {
  static constexpr std::size_t lanes = 1;
  double value;
  MUELLE_INLINE static One load(const double* p) { return {*p}; }
  void store(double* p) const { *p = value; }
};

/// What one lane's error is over what is allowed there: see errorRatio().
template <class T>
MUELLE_INLINE inline T ratioOf(const T& error, const T& from, const T& to, double allowed) {
  constexpr double rounding = 4.0 * 2.220446049250313e-16;
  T a = from, b = to, e = error;
  a.value = a.value < 0.0 ? -a.value : a.value;
  b.value = b.value < 0.0 ? -b.value : b.value;
  e.value = e.value < 0.0 ? -e.value : e.value;
  a.value = a.value > b.value ? a.value : b.value;
  e.value = e.value / (allowed + rounding * a.value);
  return e;
}

/// Runs body(T, i) over the lanes, N of them when that is not 0.
template <std::size_t N, class Body>
MUELLE_INLINE inline void overLanes(std::size_t n, Body&& body) {
  if constexpr (N > 0) {
    for (std::size_t i = 0; i < N; ++i) body(One{}, i);
  } else {
    std::size_t i = 0;
    for (; i + Wide::lanes <= n; i += Wide::lanes) body(Wide{}, i);
    for (; i < n; ++i) body(One{}, i);
  }
}

/// Runs body(j) over the terms after the first, whose number is known when compiling unless it is 0.
template <std::size_t Terms, class Body>
MUELLE_INLINE inline void overLaterTerms(const StageTerms& terms, Body&& body) {
  if constexpr (Terms > 0) {
    [&]<std::size_t... J>(std::index_sequence<J...>) MUELLE_INLINE { (body(J + 1), ...); }
    (std::make_index_sequence<Terms - 1>{});
  } else {
    for (std::size_t j = 1; j < terms.count; ++j) body(j);
  }
}

template <std::size_t N, std::size_t Terms, bool Velocity>
void stageOf(const StageBase& base, const StageTerms& terms, double c, double* __restrict X, double* __restrict V) {
  const double h = base.h;
  overLanes<N>(base.n, [&](auto kind, std::size_t i) MUELLE_INLINE {
    using T = decltype(kind);
    T x = T::load(terms.a[0] + i), v = x;
    x.value = terms.wx[0] * x.value;
    v.value = terms.wv[0] * v.value;
    overLaterTerms<Terms>(terms, [&](std::size_t j) MUELLE_INLINE {
      const T a = T::load(terms.a[j] + i);
      x.value = x.value + terms.wx[j] * a.value;
      if constexpr (Velocity) v.value = v.value + terms.wv[j] * a.value;
    });
    const T v0 = T::load(base.v + i);
    x.value = T::load(base.x + i).value + h * (c * v0.value + h * x.value);
    x.store(X + i);
    if constexpr (Velocity) {
      v.value = v0.value + h * v.value;
      v.store(V + i);
    }
  });
}

template <std::size_t N, std::size_t Terms, std::size_t Estimates>
void endOf(const StageBase& base, const StageTerms& terms, const StageEstimate* estimates, double allowedX,
           double allowedV, double* __restrict X, double* __restrict V, StageEnd& result) {
  const double h = base.h, hh = h * h;
  Wide wideBad{}, wideLargest[2]{};
  One oneBad{}, oneLargest[2]{};
  overLanes<N>(base.n, [&](auto kind, std::size_t i) MUELLE_INLINE {
    using T = decltype(kind);
    T x = T::load(terms.a[0] + i), v = x, ex[2] = {x, x}, ev[2] = {x, x};
    x.value = terms.wx[0] * x.value;
    v.value = terms.wv[0] * v.value;
    for (std::size_t e = 0; e != Estimates; ++e) {
      ex[e].value = estimates[e].ex[0] * ex[e].value;
      ev[e].value = estimates[e].ev[0] * ev[e].value;
    }
    overLaterTerms<Terms>(terms, [&](std::size_t j) MUELLE_INLINE {
      const T a = T::load(terms.a[j] + i);
      x.value = x.value + terms.wx[j] * a.value;
      v.value = v.value + terms.wv[j] * a.value;
      for (std::size_t e = 0; e != Estimates; ++e) {
        ex[e].value = ex[e].value + estimates[e].ex[j] * a.value;
        ev[e].value = ev[e].value + estimates[e].ev[j] * a.value;
      }
    });
    const T x0 = T::load(base.x + i), v0 = T::load(base.v + i);
    x.value = x0.value + h * (v0.value + h * x.value);
    v.value = v0.value + h * v.value;
    x.store(X + i);
    v.store(V + i);
    const auto look = [&](auto& bad, auto& largest) MUELLE_INLINE {
      bad.value = bad.value + (0.0 * x.value + 0.0 * v.value);
      for (std::size_t e = 0; e != Estimates; ++e) {
        ex[e].value = hh * ex[e].value;
        ev[e].value = h * ev[e].value;
        bad.value = bad.value + (0.0 * ex[e].value + 0.0 * ev[e].value);
        const T rx = ratioOf(ex[e], x0, x, allowedX), rv = ratioOf(ev[e], v0, v, allowedV);
        largest[e].value = rx.value > largest[e].value ? rx.value : largest[e].value;
        largest[e].value = rv.value > largest[e].value ? rv.value : largest[e].value;
      }
    };
    if constexpr (T::lanes == 1) {
      look(oneBad, oneLargest);
    } else {
      look(wideBad, wideLargest);
    }
  });
  result.notFinite = oneBad.value;
  for (std::size_t k = 0; k < Wide::lanes; ++k) result.notFinite += wideBad.value[k];
  for (std::size_t e = 0; e != Estimates; ++e) {
    double most = oneLargest[e].value;
    for (std::size_t k = 0; k < Wide::lanes; ++k) {
      most = wideLargest[e].value[k] > most ? wideLargest[e].value[k] : most;
    }
    result.largest[e] = most;
  }
}

// With few lanes the terms are counted when running: only the newest of them is waited for.
template <std::size_t N>
void fewStage(const StageBase& base, const StageTerms& terms, double c, double* X, double* V) {
  if (V == nullptr) return stageOf<N, 0, false>(base, terms, c, X, V);
  stageOf<N, 0, true>(base, terms, c, X, V);
}

template <std::size_t N>
void fewEnd(const StageBase& base, const StageTerms& terms, const StageEstimate* estimates, std::size_t count,
            double allowedX, double allowedV, double* X, double* V, StageEnd& result) {
  if (count == 0) return endOf<N, 0, 0>(base, terms, estimates, allowedX, allowedV, X, V, result);
  if (count == 1) return endOf<N, 0, 1>(base, terms, estimates, allowedX, allowedV, X, V, result);
  endOf<N, 0, 2>(base, terms, estimates, allowedX, allowedV, X, V, result);
}

/// With many, each number of terms has a loop of its own.
template <std::size_t Terms>
void manyStage(const StageBase& base, const StageTerms& terms, double c, double* X, double* V) {
  if (terms.count != Terms) {
    if constexpr (Terms > 1) manyStage<Terms - 1>(base, terms, c, X, V);
    return;
  }
  if (V == nullptr) return stageOf<0, Terms, false>(base, terms, c, X, V);
  stageOf<0, Terms, true>(base, terms, c, X, V);
}

template <std::size_t Terms>
void manyEnd(const StageBase& base, const StageTerms& terms, const StageEstimate* estimates, std::size_t count,
             double allowedX, double allowedV, double* X, double* V, StageEnd& result) {
  if (terms.count != Terms) {
    if constexpr (Terms > 1) manyEnd<Terms - 1>(base, terms, estimates, count, allowedX, allowedV, X, V, result);
    return;
  }
  if (count == 0) return endOf<0, Terms, 0>(base, terms, estimates, allowedX, allowedV, X, V, result);
  if (count == 1) return endOf<0, Terms, 1>(base, terms, estimates, allowedX, allowedV, X, V, result);
  endOf<0, Terms, 2>(base, terms, estimates, allowedX, allowedV, X, V, result);
}

/// V = v + k a, X = x + h V, P = V + k a.
template <std::size_t N, bool Look, bool Predict>
double kickDriftOf(std::size_t n, const double* x, const double* v, const double* a, double k, double h,
                   double* __restrict X, double* __restrict V, double* __restrict P) {
  Wide wideBad{};
  One oneBad{};
  overLanes<N>(n, [&](auto kind, std::size_t i) MUELLE_INLINE {
    using T = decltype(kind);
    T velocity = T::load(v + i), position = T::load(x + i), kick = T::load(a + i);
    kick.value = k * kick.value;
    velocity.value = velocity.value + kick.value;
    position.value = position.value + h * velocity.value;
    velocity.store(V + i);
    position.store(X + i);
    if constexpr (Look && T::lanes == 1) oneBad.value += 0.0 * velocity.value + 0.0 * position.value;
    if constexpr (Look && T::lanes > 1) wideBad.value += 0.0 * velocity.value + 0.0 * position.value;
    if constexpr (Predict) {
      velocity.value = velocity.value + kick.value;
      velocity.store(P + i);
    }
  });
  for (std::size_t j = 0; j < Wide::lanes; ++j) oneBad.value += wideBad.value[j];
  return oneBad.value;
}

template <std::size_t N>
double kickDrift(std::size_t n, const double* x, const double* v, const double* a, double h, double* X, double* V) {
  return kickDriftOf<N, true, false>(n, x, v, a, h, h, X, V, nullptr);
}

template <std::size_t N>
void halfKickDrift(std::size_t n, const double* x, const double* v, const double* a, double h, double* X, double* V,
                   double* P) {
  if (P != nullptr) {
    kickDriftOf<N, false, true>(n, x, v, a, 0.5 * h, h, X, V, P);
  } else {
    kickDriftOf<N, false, false>(n, x, v, a, 0.5 * h, h, X, V, nullptr);
  }
}

template <std::size_t N>
double halfKick(std::size_t n, const double* a, double h, const double* X, double* __restrict V) {
  const double k = 0.5 * h;
  Wide wideBad{};
  One oneBad{};
  overLanes<N>(n, [&](auto kind, std::size_t i) MUELLE_INLINE {
    using T = decltype(kind);
    T velocity = T::load(V + i);
    velocity.value = velocity.value + k * T::load(a + i).value;
    velocity.store(V + i);
    const T position = T::load(X + i);
    if constexpr (T::lanes == 1) oneBad.value += 0.0 * velocity.value + 0.0 * position.value;
    if constexpr (T::lanes > 1) wideBad.value += 0.0 * velocity.value + 0.0 * position.value;
  });
  for (std::size_t j = 0; j < Wide::lanes; ++j) oneBad.value += wideBad.value[j];
  return oneBad.value;
}

}  // namespace

/// By the number of lanes: any, 1, 2, 3, 4.
extern const StageKernels MUELLE_KERNELS[5];
const StageKernels MUELLE_KERNELS[5] = {
    {manyStage<mostStageTerms>, manyEnd<mostStageTerms>, kickDrift<0>, halfKickDrift<0>, halfKick<0>},
    {fewStage<1>, fewEnd<1>, kickDrift<1>, halfKickDrift<1>, halfKick<1>},
    {fewStage<2>, fewEnd<2>, kickDrift<2>, halfKickDrift<2>, halfKick<2>},
    {fewStage<3>, fewEnd<3>, kickDrift<3>, halfKickDrift<3>, halfKick<3>},
    {fewStage<4>, fewEnd<4>, kickDrift<4>, halfKickDrift<4>, halfKick<4>}};

}  // namespace muelle::engine
