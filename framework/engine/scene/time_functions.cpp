#include "engine/scene/time_functions.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace muelle::engine {

namespace {

/// The stretch of time in which something acts, as declared times: those that are no limits of time itself.
struct Stretch {
  double from, to;

  std::vector<double> times() const {
    std::vector<double> times;
    if (from > 0.0) times.push_back(from);
    if (std::isfinite(to)) times.push_back(to);
    return times;
  }
  int segment() const { return from > 0.0 ? 1 : 0; }
  std::vector<double> periods(double frequency) const {
    if (frequency == 0.0) return {};
    std::vector<double> periods(times().size() + 1, std::numeric_limits<double>::infinity());
    periods[static_cast<std::size_t>(segment())] = 1.0 / frequency;
    return periods;
  }
};

/// Moves as `displacement` says between `from` and `to`; before and afterwards it rests.
template <class Displacement, class Velocity>
Motion during(const Stretch& stretch, double frequency, Displacement displacement, Velocity velocity) {
  const Vec3 end = std::isfinite(stretch.to) ? Vec3(displacement(stretch.to)) : Vec3(Vec3::Zero());
  return {[=](double t, int segment) -> Vec3 {
            if (segment < stretch.segment()) return Vec3::Zero();
            return segment > stretch.segment() ? end : Vec3(displacement(t));
          },
          [=](double t, int segment) -> Vec3 {
            return segment == stretch.segment() ? Vec3(velocity(t)) : Vec3(Vec3::Zero());
          },
          stretch.times(), stretch.periods(frequency)};
}

}  // namespace

Motion smoothStroke(const Vec3& d, double from, double to) {
  const auto part = [from, to](double t) { return (t - from) / (to - from); };
  return during(
      {from, to}, 0.0,
      [=](double t) -> Vec3 {
        const double s = part(t);
        return d * (s * s * s * (10.0 + s * (6.0 * s - 15.0)));
      },
      [=](double t) -> Vec3 {
        const double s = part(t);
        return d * (30.0 * s * s * (1.0 - s) * (1.0 - s) / (to - from));
      });
}

Motion oscillation(const Vec3& amplitude, double frequency, double from, double to) {
  const double omega = 2.0 * std::numbers::pi * frequency;
  return during(
      {from, to}, frequency, [=](double t) -> Vec3 { return amplitude * std::sin(omega * (t - from)); },
      [=](double t) -> Vec3 { return amplitude * omega * std::cos(omega * (t - from)); });
}

Motion steadyMotion(const Vec3& v, double from, double to) {
  return during(
      {from, to}, 0.0, [=](double t) -> Vec3 { return v * (t - from); }, [=](double) -> Vec3 { return v; });
}

Motion startingAt(const Vec3& x, const Motion& about) {
  Motion motion = about;
  motion.position = [x, move = about.position](double t, int segment) -> Vec3 { return x + move(t, segment); };
  return motion;
}

ModelExternalForce externalForce(std::vector<int> nodes, const Vec3& F, double from, double to, double frequency) {
  const Stretch stretch{from, to};
  ModelExternalForce force;
  force.nodes = std::move(nodes);
  force.times = stretch.times();
  force.periods = stretch.periods(frequency);
  const double omega = 2.0 * std::numbers::pi * frequency;
  force.force = [=](double t, int segment) -> Vec3 {
    if (segment != stretch.segment()) return Vec3::Zero();
    return frequency > 0.0 ? Vec3(F * std::sin(omega * (t - from))) : F;
  };
  return force;
}

}  // namespace muelle::engine
