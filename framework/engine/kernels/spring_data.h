#pragma once

namespace muelle::engine::kernels {

/// A spring between the nodes a and b, as the builders take it. The force on a is
/// F = -k (L - L0) n - dRelative w - dProjected (w . n) n with d = xa - xb, L = |d|, n = d / L, w = va - vb; b has -F.
/// Where L = 0 only -dRelative w is left. In 1D the two dampings are the same force, at L = 0 too.
struct SpringData {
  int a = 0, b = 1;
  double k = 0.0;           ///< [N/m]
  double L0 = 0.0;          ///< [m]
  double dRelative = 0.0;   ///< [kg/s]
  double dProjected = 0.0;  ///< [kg/s]
};

/// Which damping a batch of springs has: the loops differ.
enum class Damping { None, Relative, Projected, Both };
inline constexpr int dampingForms = 4;

/// The form of a spring; in 1D there is one damping.
inline Damping dampingOf(const SpringData& s, int dimension) {
  const bool projected = s.dProjected != 0.0, relative = s.dRelative != 0.0;
  if (dimension == 1) return projected || relative ? Damping::Relative : Damping::None;
  if (projected) return relative ? Damping::Both : Damping::Projected;
  return relative ? Damping::Relative : Damping::None;
}

/// The one coefficient of relative damping that the loops of the dimension take [kg/s].
inline double relativeDampingOf(const SpringData& s, int dimension) {
  return dimension == 1 ? s.dRelative + s.dProjected : s.dRelative;
}

}  // namespace muelle::engine::kernels
