#pragma once
#include "engine/contact/touch.h"

#include <cmath>

namespace muelle::engine {

/// Coulomb friction as a spring-slider (Dahl 1968; Cundall and Strack 1979): a spring k_t and a damper d_t join the
/// node to an anchor on the surface, tau = -P (k_t xi + d_t w), P = I - n n^T; where |tau| exceeds mu N the slider
/// gives way and the force is mu N tau / |tau|. It sticks: at rest it carries any force up to mu N without creep. The
/// anchor is an internal variable and moves between steps alone, so the force is continuous within one.
template <int D>
struct Slider {
  using Vector = Eigen::Matrix<double, D, 1>;
  using Block = Eigen::Matrix<double, D, D>;

  double mu = 0.0;
  double k = 0.0;  ///< tangential [N/m]
  double d = 0.0;  ///< tangential [kg/s]

  struct Grip {
    Vector trial = Vector::Zero();  ///< [N], before the slider gives way
    double limit = 0.0;             ///< mu N [N]
    bool slips = false;
    Vector force = Vector::Zero();  ///< [N]
  };

  /// \param xi from the anchor to the node [m]   \param w velocity relative to the obstacle [m/s]
  /// \param N normal force [N]; none below 0
  Grip grip(const Vector& xi, const Vector& w, const Vector& n, double N) const {
    Grip grip;
    const Vector u = k * xi + d * w;
    grip.trial = n * n.dot(u) - u;
    grip.limit = mu * std::fmax(N, 0.0);
    const double size = grip.trial.norm();
    grip.slips = size > grip.limit;
    grip.force = grip.slips ? Vector((grip.limit / size) * grip.trial) : grip.trial;
    return grip;
  }

  /// Adds to K = -dF/dx and D = -dF/dv. \param dNdx, dNdv gradients of the normal force, 0 where there is none
  /// \param exact with the coupling of the slip limit to the normal force and the turning of the normal, which are not
  /// symmetric; without them what is added is positive semidefinite
  void addDerivatives(const Grip& grip, const Vector& xi, const Vector& w, const Touch<D>& touch, const Vector& dNdx,
                      const Vector& dNdv, bool exact, Block& K, Block& damping) const {
    const Vector& n = touch.normal;
    const Block P = Block::Identity() - n * n.transpose();
    Block dTrialdx = -k * P;
    if (exact && touch.curvature != 0.0) {
      const Vector u = k * xi + d * w;
      dTrialdx += touch.curvature * (n.dot(u) * P + n * (P * u).transpose());
    }
    if (!grip.slips) {
      K -= dTrialdx;
      damping += d * P;
      return;
    }
    const double size = grip.trial.norm();
    const Vector along = grip.trial / size;
    const Block across = (grip.limit / size) * (Block::Identity() - along * along.transpose());
    K -= across * dTrialdx;
    damping += d * across * P;
    if (!exact) return;
    K -= mu * along * dNdx.transpose();
    damping -= mu * along * dNdv.transpose();
  }
};

}  // namespace muelle::engine
