/// \file
/// The kernels of stage_kernels.h for one instruction set: included once by each of the sources that are compiled for
/// one, which defines MUELLE_LANES (doubles in a register) and MUELLE_KERNELS (a name). No inline function of another
/// header may be called here: the linker could take this file's copy for all.

#include "engine/integrators/explicit/engines/stage_kernels.h"

/// A block stays in registers only where nothing is called.
#define MUELLE_INLINE __attribute__((always_inline))
/// The next statement for each register k of a block.
#define MUELLE_EACH_PART _Pragma("GCC unroll 4") for (std::size_t k = 0; k != Count; ++k)

namespace muelle::engine {

namespace {

template <std::size_t Lanes>
struct RegisterOf;
template <>
struct RegisterOf<1> {
  using Type = double;
};
template <>
struct RegisterOf<2> {
  using Type = double __attribute__((vector_size(16), aligned(8), may_alias));
};
template <>
struct RegisterOf<4> {
  using Type = double __attribute__((vector_size(32), aligned(8), may_alias));
};
template <>
struct RegisterOf<8> {
  using Type = double __attribute__((vector_size(64), aligned(8), may_alias));
};
template <std::size_t Lanes>
using Register = typename RegisterOf<Lanes>::Type;

/// Registers side by side: while one waits for its last addition, the others go on, and a weight is read once for all.
template <std::size_t Lanes, std::size_t Count>
struct Block {
  static constexpr std::size_t lanes = Lanes, size = Lanes * Count;
  Register<Lanes> part[Count];

  MUELLE_INLINE static Block zero() {
    Block block;
    MUELLE_EACH_PART { block.part[k] = Register<Lanes>{}; }
    return block;
  }
  MUELLE_INLINE static Block load(const double* p) {
    Block block;
    MUELLE_EACH_PART { block.part[k] = *reinterpret_cast<const Register<Lanes>*>(p + k * Lanes); }
    return block;
  }
  MUELLE_INLINE void store(double* p) const {
    MUELLE_EACH_PART { *reinterpret_cast<Register<Lanes>*>(p + k * Lanes) = part[k]; }
  }
  MUELLE_INLINE friend Block operator+(const Block& a, const Block& b) {
    Block sum;
    MUELLE_EACH_PART { sum.part[k] = a.part[k] + b.part[k]; }
    return sum;
  }
  MUELLE_INLINE friend Block operator*(double a, const Block& b) {
    Block product;
    MUELLE_EACH_PART { product.part[k] = a * b.part[k]; }
    return product;
  }
};

/// Runs body(block, first lane) over all lanes, whose number is N unless that is 0. The last block may begin inside the
/// one before, of which it computes a part again.
template <std::size_t Lanes, std::size_t N, class Body>
MUELLE_INLINE inline void overBlocks(std::size_t n, Body&& body) {
  if constexpr (N > 0) {
    body(Block<Lanes, N / Lanes>{}, 0);
  } else {
    std::size_t i = 0;
    for (; i + 4 * Lanes <= n; i += 4 * Lanes) body(Block<Lanes, 4>{}, i);
    for (; i + Lanes <= n; i += Lanes) body(Block<Lanes, 1>{}, i);
    if (i < n && n >= Lanes) return body(Block<Lanes, 1>{}, n - Lanes);
    for (; i < n; ++i) body(Block<1, 1>{}, i);
  }
}

/// What is collected over all lanes, in a register for whole ones and a number for the rest: a sum, or the largest. A
/// block's parts come together first, as each waits for the last.
template <std::size_t Lanes>
struct Collected {
  Register<Lanes> wide{};
  double one{};

  template <std::size_t Count>
  MUELLE_INLINE void add(const Block<Lanes, Count>& block) {
    wide = wide + sumOf(block);
  }
  template <std::size_t Count>
  MUELLE_INLINE void takeLarger(const Block<Lanes, Count>& block) {
    const Register<Lanes> most = largest(block);
    wide = most > wide ? most : wide;
  }
  MUELLE_INLINE void add(const Block<1, 1>& block) requires(Lanes > 1) { one = one + block.part[0]; }
  MUELLE_INLINE void takeLarger(const Block<1, 1>& block) requires(Lanes > 1) {
    one = block.part[0] > one ? block.part[0] : one;
  }
  MUELLE_INLINE double sum() const {
    double all = one;
    for (std::size_t k = 0; k != Lanes; ++k) all += lane(k);
    return all;
  }
  MUELLE_INLINE double largest() const {
    double all = one;
    for (std::size_t k = 0; k != Lanes; ++k) all = lane(k) > all ? lane(k) : all;
    return all;
  }

 private:
  template <std::size_t Count>
  MUELLE_INLINE static Register<Lanes> sumOf(const Block<Lanes, Count>& block) {
    Register<Lanes> sum = block.part[0];
    for (std::size_t k = 1; k < Count; ++k) sum = sum + block.part[k];
    return sum;
  }
  template <std::size_t Count>
  MUELLE_INLINE static Register<Lanes> largest(const Block<Lanes, Count>& block) {
    Register<Lanes> most = block.part[0];
    for (std::size_t k = 1; k < Count; ++k) most = block.part[k] > most ? block.part[k] : most;
    return most;
  }
  MUELLE_INLINE double lane(std::size_t k) const {
    if constexpr (Lanes == 1) {
      return wide;
    } else {
      return wide[k];
    }
  }
};

/// x = sum wx_j a_j and v = sum wv_j a_j of one block.
template <class B>
struct Sums {
  B x, v;
};

/// Of the first `count` terms, in x and v.
template <class B>
MUELLE_INLINE inline Sums<B> sumsOf(const StageTerms& terms, std::size_t count, const double* wx, const double* wv,
                                    std::size_t i) {
  if (count == 0) return {B::zero(), B::zero()};
  const B first = B::load(terms.a[0] + i);
  B x = wx[0] * first, v = wv[0] * first;
  for (std::size_t j = 1; j < count; ++j) {
    const B a = B::load(terms.a[j] + i);
    x = x + wx[j] * a;
    v = v + wv[j] * a;
  }
  return {x, v};
}

/// x = sum wx_j a_j, added to those of the first terms.
template <class B>
MUELLE_INLINE inline B withPositions(B x, const StageTerms& terms, std::size_t i) {
  for (std::size_t j = terms.both, end = j + terms.positions; j < end; ++j) {
    x = x + terms.wx[j] * B::load(terms.a[j] + i);
  }
  return x;
}
/// v = sum wv_j a_j, the same.
template <class B>
MUELLE_INLINE inline B withVelocities(B v, const StageTerms& terms, std::size_t i) {
  for (std::size_t j = terms.both + terms.positions, end = j + terms.velocities; j < end; ++j) {
    v = v + terms.wv[j] * B::load(terms.a[j] + i);
  }
  return v;
}

template <std::size_t Lanes, std::size_t N>
void stage(const StageBase& base, const StageTerms& terms, double c, double* X, double* V) {
  const double ch = c * base.h;
  overBlocks<Lanes, N>(base.n, [&](auto kind, std::size_t i) MUELLE_INLINE {
    using B = decltype(kind);
    const Sums<B> sums = sumsOf<B>(terms, terms.both, terms.wx, terms.wv, i);
    const B v = B::load(base.v + i);
    const B x = B::load(base.x + i) + (ch * v + withPositions(sums.x, terms, i));
    x.store(X + i);
    if (V != nullptr) (v + withVelocities(sums.v, terms, i)).store(V + i);
  });
}

/// One over what an error may be, from the values at both ends of the step: see errorRatio().
template <std::size_t Lanes, std::size_t Count>
MUELLE_INLINE inline Block<Lanes, Count> scaleOf(Block<Lanes, Count> from, Block<Lanes, Count> to, double allowed) {
  constexpr double rounding = 4.0 * 2.220446049250313e-16;
  MUELLE_EACH_PART {
    auto &a = from.part[k], &b = to.part[k];
    a = a < 0.0 ? -a : a;
    b = b < 0.0 ? -b : b;
    a = a > b ? a : b;
    a = 1.0 / (allowed + rounding * a);
  }
  return from;
}

/// |error| scale
template <std::size_t Lanes, std::size_t Count>
MUELLE_INLINE inline Block<Lanes, Count> ratioOf(Block<Lanes, Count> error, const Block<Lanes, Count>& scale) {
  MUELLE_EACH_PART {
    auto& e = error.part[k];
    e = e < 0.0 ? -e : e;
    e = e * scale.part[k];
  }
  return error;
}

template <std::size_t Lanes, std::size_t N>
void end(const StageBase& base, const StageTerms& terms, const StageEstimate* estimates, std::size_t count,
         double allowedX, double allowedV, double* X, double* V, StageEnd& result) {
  Collected<Lanes> total, largest[2];
  overBlocks<Lanes, N>(base.n, [&](auto kind, std::size_t i) MUELLE_INLINE {
    using B = decltype(kind);
    const Sums<B> sums = sumsOf<B>(terms, terms.both, terms.wx, terms.wv, i);
    const B v0 = B::load(base.v + i), x0 = B::load(base.x + i);
    const B x = x0 + (base.h * v0 + withPositions(sums.x, terms, i)), v = v0 + withVelocities(sums.v, terms, i);
    x.store(X + i);
    v.store(V + i);
    total.add(x + v);
    if (count == 0) return;
    const B scaleX = scaleOf(x0, x, allowedX), scaleV = scaleOf(v0, v, allowedV);
    for (std::size_t e = 0; e != count; ++e) {
      const Sums<B> errors = sumsOf<B>(terms, terms.count, estimates[e].ex, estimates[e].ev, i);
      total.add(errors.x + errors.v);
      largest[e].takeLarger(ratioOf(errors.x, scaleX));
      largest[e].takeLarger(ratioOf(errors.v, scaleV));
    }
  });
  result.sum = total.sum();
  for (std::size_t e = 0; e != count; ++e) result.largest[e] = largest[e].largest();
}

template <std::size_t Lanes, std::size_t N>
double kickDrift(std::size_t n, const double* x, const double* v, const double* a, double h, double* X, double* V) {
  Collected<Lanes> total;
  overBlocks<Lanes, N>(n, [&](auto kind, std::size_t i) MUELLE_INLINE {
    using B = decltype(kind);
    const B velocity = B::load(v + i) + h * B::load(a + i);
    const B position = B::load(x + i) + h * velocity;
    velocity.store(V + i);
    position.store(X + i);
    total.add(velocity + position);
  });
  return total.sum();
}

template <std::size_t Lanes, std::size_t N>
double halfKickDrift(std::size_t n, const double* x, const double* v, const double* a, double h, double* X, double* P) {
  Collected<Lanes> total;
  overBlocks<Lanes, N>(n, [&](auto kind, std::size_t i) MUELLE_INLINE {
    using B = decltype(kind);
    const B kick = (0.5 * h) * B::load(a + i);
    const B velocity = B::load(v + i) + kick;
    const B position = B::load(x + i) + h * velocity;
    position.store(X + i);
    total.add(position);
    if (P != nullptr) (velocity + kick).store(P + i);
  });
  return total.sum();
}

template <std::size_t Lanes, std::size_t N>
double twoHalfKicks(std::size_t n, const double* v, const double* a, const double* b, double h, double* V) {
  Collected<Lanes> total;
  overBlocks<Lanes, N>(n, [&](auto kind, std::size_t i) MUELLE_INLINE {
    using B = decltype(kind);
    const B velocity = B::load(v + i) + (0.5 * h) * B::load(a + i) + (0.5 * h) * B::load(b + i);
    velocity.store(V + i);
    total.add(velocity);
  });
  return total.sum();
}

/// What stages need is arithmetic, of which the widest registers do most; what the other three do is to load and to
/// store, for which four lanes are enough: more span two lines of the cache wherever a state's vector begins.
constexpr std::size_t narrow = MUELLE_LANES > 4 ? 4 : MUELLE_LANES;

template <std::size_t Lanes, std::size_t N>
constexpr StageKernels kernelsFor{stage<Lanes, N>, end<Lanes, N>, kickDrift<(Lanes > narrow ? narrow : Lanes), N>,
                                  halfKickDrift<(Lanes > narrow ? narrow : Lanes), N>,
                                  twoHalfKicks<(Lanes > narrow ? narrow : Lanes), N>};

}  // namespace

/// By the number of lanes: any, 1, 2, 3, 4. A node of two or four lanes is written in one piece, as forces read it: a
/// load waits long for two stores that it spans.
extern const StageKernels MUELLE_KERNELS[5];
const StageKernels MUELLE_KERNELS[5] = {kernelsFor<MUELLE_LANES, 0>, kernelsFor<1, 1>, kernelsFor<2, 2>,
                                        kernelsFor<1, 3>, kernelsFor<narrow, 4>};

}  // namespace muelle::engine
