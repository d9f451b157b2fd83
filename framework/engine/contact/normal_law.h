#pragma once
#include "engine/capabilities.h"
#include "engine/contact/meeting.h"
#include "engine/forces/mode.h"

#include <algorithm>
#include <cmath>

namespace muelle::engine {

/// The force across an obstacle's surface: N = k depth - d w . n, and when it is there.
template <int D>
struct NormalLaw {
  using Vector = Eigen::Matrix<double, D, 1>;
  using Block = Eigen::Matrix<double, D, D>;

  double k = 0.0;  ///< [N/m]
  double d = 0.0;  ///< [kg/s]

  double asIfClosed(const Touch<D>& touch, const Vector& w) const { return k * touch.depth - d * w.dot(touch.normal); }

  /// [N]; one-sided when live.
  double force(const Meeting<D>& m, double mode) const {
    if (!m.acts) return 0.0;
    return mode == mode::live ? std::max(0.0, m.N) : m.N;
  }

  /// Below 0 where the contact is closed: -min(-gap, N / k), so that a damped one lets go where N = 0 [m].
  double guard(const Meeting<D>& m) const { return d == 0.0 ? m.touch.gap : -std::min(-m.touch.gap, m.N / k); }

  /// The mode at a commit that freezes. A mode that was frozen before changes only where it is wrong and getting worse:
  /// right after an event the guard is 0 but for rounding, and its sign says nothing.
  double modeAfter(double old, const Meeting<D>& m) const {
    const double g = guard(m), rate = m.w.dot(m.touch.normal);
    if (old == mode::live) return g < 0.0 || (g == 0.0 && rate <= 0.0) ? mode::closed : mode::open;
    const double noise = 1e-6 * (k * std::abs(m.touch.depth) + d * std::abs(rate));
    if (old == mode::closed) {
      const bool left = m.touch.gap > 0.0 && rate > 0.0;
      const bool pulls = d > 0.0 && m.touch.gap <= 0.0 && m.N < -noise;
      return left || pulls ? mode::open : mode::closed;
    }
    const bool pushes = m.touch.gap < 0.0 && (d > 0.0 ? m.N > noise : rate < 0.0);
    return pushes ? mode::closed : mode::open;
  }

  /// The mode beyond an event. Without damping the direction of motion tells the far side, whatever the mode was.
  double modeBeyond(double old, const Meeting<D>& m) const {
    const double rate = m.w.dot(m.touch.normal);
    const double toggled = old == mode::closed ? mode::open : mode::closed;
    return d > 0.0 || rate == 0.0 ? toggled : rate < 0.0 ? mode::closed : mode::open;
  }

  /// K = -dF/dx, D = -dF/dv of the force N n, and the gradients of N.
  struct Derivatives {
    Block K = Block::Zero(), damping = Block::Zero();
    Vector dNdx = Vector::Zero(), dNdv = Vector::Zero();
  };
  Derivatives derivatives(const Meeting<D>& m, Form form) const {
    const Vector& n = m.touch.normal;
    const double curvature = m.touch.curvature;
    const Block P = Block::Identity() - n * n.transpose();
    Derivatives all;
    all.dNdx = -k * n - d * curvature * (P * m.w);
    all.dNdv = -d * n;
    all.damping = d * n * n.transpose();
    all.K = k * n * n.transpose();
    if (form != Form::Projected) all.K -= k * m.touch.depth * curvature * P;
    if (form == Form::Exact) all.K += d * curvature * (n * (P * m.w).transpose() + m.w.dot(n) * P);
    return all;
  }
};

}  // namespace muelle::engine
