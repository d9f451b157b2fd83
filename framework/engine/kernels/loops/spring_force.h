#pragma once
/// \file
/// The force of one spring: for the springs that are left over by whole registers, and where a length or a force is out
/// of the range in which the squares are right. In an unnamed namespace, as all that is compiled per instruction set:
/// two copies of different flags must not be taken for one.

namespace muelle::engine::kernels {
namespace {

/// A square of a length in this range is neither cut off nor overflows, and its root is right.
constexpr double smallestSquare = 1e-280;
/// A force per length beyond this is formed in an order that cannot overflow by itself.
constexpr double largestRatio = 1e300;

struct Material {
  double k, L0, dRelative, dProjected;
};

/// With the length formed from scaled components, as engine/forces/length.h does. F is the force on the end a.
template <int D, bool relative, bool projected>
__attribute__((noinline)) void carefulForce(const double* d, const double* w, const Material& m, double* F) {
  double largest = 0.0;
  for (int c = 0; c < D; ++c) {
    const double size = __builtin_fabs(d[c]);
    if (size > largest || size != size) largest = size;  // what is no number stays
  }
  double n[D] = {};
  double q = 0.0;
  if (largest != 0.0) {
    int exponent = 0;
    const double fraction = __builtin_frexp(largest, &exponent);
    double square = 0.0;
    for (int c = 0; c < D; ++c) {
      n[c] = __builtin_ldexp(d[c], -exponent);
      square += n[c] * n[c];
    }
    const double scaled = __builtin_sqrt(square);
    const double L = __builtin_isfinite(fraction) ? __builtin_ldexp(scaled, exponent) : fraction;
    for (int c = 0; c < D; ++c) n[c] /= scaled;
    q = m.k * (m.L0 - L);
    if constexpr (projected) {
      double speed = 0.0;
      for (int c = 0; c < D; ++c) speed += w[c] * n[c];
      q -= m.dProjected * speed;
    }
  }
  for (int c = 0; c < D; ++c) {
    F[c] = q * n[c];
    if constexpr (relative) F[c] -= m.dRelative * w[c];
  }
}

/// The same arithmetic, operation by operation, as a lane of the loops has.
template <int D, bool relative, bool projected>
inline void springForce(const double* d, const double* w, const Material& m, double* F) {
  if constexpr (D == 1) {
    const double pull = m.k * (m.L0 - __builtin_fabs(d[0]));
    F[0] = d[0] < 0.0 ? -pull : pull;
    if (d[0] == 0.0) F[0] = 0.0;
    if constexpr (relative) F[0] -= m.dRelative * w[0];
  } else {
    double square = d[0] * d[0];
    for (int c = 1; c < D; ++c) square += d[c] * d[c];
    const double L = __builtin_sqrt(square);
    double ratio = m.k * (m.L0 - L);
    if constexpr (projected) {
      double speed = w[0] * d[0];
      for (int c = 1; c < D; ++c) speed += w[c] * d[c];
      const double inverse = 1.0 / L;
      ratio = (ratio - m.dProjected * (speed * inverse)) * inverse;
    } else {
      ratio = ratio / L;
    }
    if (!(square > smallestSquare && __builtin_fabs(ratio) < largestRatio)) {
      carefulForce<D, relative, projected>(d, w, m, F);
      return;
    }
    for (int c = 0; c < D; ++c) {
      F[c] = ratio * d[c];
      if constexpr (relative) F[c] -= m.dRelative * w[c];
    }
  }
}

}  // namespace
}  // namespace muelle::engine::kernels
