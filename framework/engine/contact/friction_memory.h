#pragma once
#include "engine/contact/friction.h"
#include "engine/contact/meeting.h"
#include "engine/forces/length.h"
#include "engine/forces/mode.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace muelle::engine {

/// What friction keeps of one node between steps, in the internal variables: its grip and its anchor, relative to the
/// obstacle. `Value` is double, or const double where nothing is set.
template <int D, class Value>
class FrictionMemory {
 public:
  using Vector = Eigen::Matrix<double, D, 1>;

  /// How many a node has.
  static constexpr int variables = 1 + D;

  /// \param mode of the contact (forces/mode.h)   \param own the node's variables
  FrictionMemory(const Slider<D>& slider, double mode, Value* own)
      : slider_(slider), mode_(mode), grip_(*own), anchor_(own + 1) {}

  bool isApart() const { return grip_ == apart; }

  /// Friction's force on the node under the normal force N [N].
  Vector force(const Meeting<D>& m, double N) const {
    return sliderAt(m, N).grip(stretch(m), m.w, m.touch.normal, N).force;
  }

  /// Adds to K = -dF/dx and D = -dF/dv (Slider::addDerivatives).
  template <class Block>
  void addDerivatives(const Meeting<D>& m, double N, const Vector& dNdx, const Vector& dNdv, bool exact, Block& K,
                      Block& damping) const {
    const Vector xi = stretch(m);
    const Slider<D> slider = sliderAt(m, N);
    const auto grip = slider.grip(xi, m.w, m.touch.normal, N);
    slider.addDerivatives(grip, xi, m.w, m.touch, dNdx, dNdv, exact, K, damping);
  }

  /// What the anchor stores [J].
  double energy(const Meeting<D>& m, double N) const {
    if (grip_ == slips) {
      const double limit = slider_.mu * std::fmax(N, 0.0);
      return 0.5 * limit * limit / slider_.k;
    }
    const Vector xi = stretch(m);
    const double along = xi.squaredNorm() - std::pow(m.touch.normal.dot(xi), 2);
    return 0.5 * slider_.k * std::max(along, 0.0);
  }

  /// Reaches 0 where a node that slips comes to rest [m/s]: the slip has the direction of the stretch, and ends when
  /// the velocity along it does. 1 where there is nothing to watch.
  double haltGuard(const Meeting<D>& m) const {
    if (!m.acts || grip_ != slips) return 1.0;
    const Vector along = m.alongSurface(stretch(m));
    return m.w.dot(along) / std::max(length<D>(along), 1e-300);
  }

  /// At a commit: moves the anchor of a slider that slips. Returns whether the node has come to rest and asks to be
  /// balanced. \param mass [kg] of the node
  bool follow(const Meeting<D>& m, double N, double mass) {
    if (!m.acts || !(N > 0.0)) {
      grip_ = apart;
      anchor_ = m.r;
      return false;
    }
    if (isApart()) return begin(m, N, mass);
    const Vector xi = stretch(m);
    const auto grip = sliderAt(m, N).grip(xi, m.w, m.touch.normal, N);
    const bool turnedBack = grip_ == slips && m.alongSurface(m.w).dot(xi) <= 0.0;
    const bool slipsOn = !turnedBack && grip.slips;
    grip_ = slipsOn ? slips : sticks;
    if (slipsOn) anchor_ = m.r + stretchAt(grip.limit) / grip.limit * grip.force;
    return turnedBack;
  }

  /// Puts the anchor so that friction balances `load` [N], all other forces on the node, along the surface, as far as
  /// it can under the normal force N.
  template <class Load>
  void balance(const Meeting<D>& m, double N, const Load& load) {
    const Vector& n = m.touch.normal;
    Vector wanted = n * n.dot(load) - load;
    const double limit = slider_.mu * N, size = wanted.norm();
    if (size > limit) wanted *= limit / size;
    anchor_ = m.r + wanted / slider_.k;
  }

  /// At the event that ends a slip.
  void halt() { grip_ = sticks; }
  /// Sticks to where the node is now.
  void stickAt(const Vector& r) {
    grip_ = sticks;
    anchor_ = r;
  }
  /// Puts the anchor where the node is now, whatever the grip.
  void resetAnchor(const Vector& r) { anchor_ = r; }

 private:
  /// What the grip says.
  static constexpr double apart = 0.0, sticks = 1.0, slips = 2.0;

  /// A node that is new in contact: at rest it asks to be balanced; when it is too fast for the slider to hold, it
  /// slips at once; else the slider starts without stretch.
  bool begin(const Meeting<D>& m, double N, double mass) {
    const Vector along = m.alongSurface(m.w);
    const double limit = slider_.mu * N, square = along.squaredNorm();
    stickAt(m.r);
    if (square == 0.0) return true;
    if (mass * square > limit * limit / slider_.k) {
      grip_ = slips;
      anchor_ -= stretchAt(limit) * along / std::sqrt(square);
    }
    return false;
  }

  Vector stretch(const Meeting<D>& m) const { return m.r - anchor_; }

  /// How far behind a slipping node its anchor is put [m]: as far as the slider stretches at its limit; in a frozen
  /// slip, where the anchor tells the direction of the last commit and nothing else, so far that no step turns it.
  double stretchAt(double limit) const {
    constexpr double farAway = 1e9;
    return mode_ == mode::closed ? farAway : limit / slider_.k;
  }

  /// The slider as it is; for a frozen slip one that slips at any speed: of a strong damper, which takes the direction
  /// of the velocity, and past a halt within the step, which is an event, of a strong spring, which goes on in that of
  /// the last commit. (Turned by the velocity there, too, friction would push on what moves aside: a step of an
  /// implicit method that meets the halt would have no solution that Newton finds.)
  Slider<D> sliderAt(const Meeting<D>& m, double N) const {
    const Vector along = m.alongSurface(m.w);
    const double speed = along.norm();
    if (mode_ != mode::closed || grip_ != slips || speed == 0.0) return slider_;
    const double limit = slider_.mu * std::fmax(N, 0.0);
    const Vector xi = m.alongSurface(stretch(m));
    if (along.dot(xi) < 0.0) return {slider_.mu, 2.0 * limit / xi.norm(), 0.0};
    return {slider_.mu, 0.0, 2.0 * limit / speed};
  }

  const Slider<D>& slider_;
  double mode_;
  Value& grip_;
  Eigen::Map<std::conditional_t<std::is_const_v<Value>, const Vector, Vector>> anchor_;
};

}  // namespace muelle::engine
