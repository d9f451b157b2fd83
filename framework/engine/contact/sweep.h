#pragma once
#include <cmath>
#include <limits>

namespace muelle::engine {

/// The part of an obstacle's thickness by which one step may go beyond its surface, or move inside it.
inline constexpr double sweepFraction = 0.01;

/// Smallest positive time at which a distance falls by `fall` [m, positive] when it changes at `rate` [m/s] with
/// `acceleration` [m/s^2]; infinite when it never does. The root without cancellation.
inline double timeToFall(double fall, double rate, double acceleration) {
  // rate t + acceleration t^2 / 2 = -fall
  const double discriminant = rate * rate - 2.0 * acceleration * fall;
  if (!(discriminant >= 0.0)) return std::numeric_limits<double>::infinity();
  const double root = std::sqrt(discriminant);
  // The smallest positive root is 2 fall / (-rate + root) when that is positive: falling, or pulled back harder.
  const double below = root - rate;
  return below > 0.0 ? 2.0 * fall / below : std::numeric_limits<double>::infinity();
}

/// How long a node may move so that no step carries it more than `sweepFraction` of the thickness into an obstacle, or
/// deeper inside it.
///
/// Outside a convex obstacle the distance to the plane through the nearest point of its surface decides: a node that
/// comes from afar is stopped just short of it, so that the step that enters is itself a short one (a long step that
/// ends inside would be thrown back by the whole push times its length). Inside, movement along the normal counts, the
/// push included. A node that rests, or slides, bounds nothing.
///
/// \param gap signed distance [m]   \param rate its rate [m/s]   \param rateOfRate its acceleration [m/s^2]
inline double sweptTime(double gap, double rate, double rateOfRate, double thickness) {
  const double allowed = sweepFraction * thickness;
  if (gap > allowed) return timeToFall(gap - 0.5 * allowed, rate, rateOfRate);
  if (gap > 0.0) return timeToFall(allowed, rate, rateOfRate);
  return timeToFall(allowed, -std::abs(rate), -std::abs(rateOfRate));
}

}  // namespace muelle::engine
