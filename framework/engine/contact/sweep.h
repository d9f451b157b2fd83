#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

namespace muelle::engine {

/// The part of an obstacle's thickness by which one step may go beyond its surface, or move inside it.
inline constexpr double sweepFraction = 0.1;

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

/// How long a node may move before it can be `sweepFraction` of the thickness deeper in an obstacle.
///
/// Outside a convex obstacle the distance to the plane through the nearest point of its surface decides. Inside, any
/// movement counts, the contact's own push included: so a step cannot carry the node through, nor be so long that the
/// push throws it out. A node at rest, with no net force, bounds nothing.
///
/// \param gap signed distance [m]   \param rate its rate, \param rateOfRate its acceleration
/// \param speed, acceleration absolute, relative to the obstacle
inline double sweptTime(double gap, double rate, double rateOfRate, double speed, double acceleration,
                        double thickness) {
  const double allowed = sweepFraction * thickness;
  if (gap > 0.0) return timeToFall(gap + allowed, rate, rateOfRate);
  return timeToFall(allowed, -speed, -acceleration);
}

}  // namespace muelle::engine
