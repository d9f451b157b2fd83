#include "engine/scene/time_functions.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace muelle::engine {

Motion smoothStroke(const Vec3& d, double from, double to) {
  const auto part = [from, to](double t) { return std::clamp((t - from) / (to - from), 0.0, 1.0); };
  return {[=](double t) -> Vec3 {
            const double s = part(t);
            return d * (s * s * s * (10.0 + s * (6.0 * s - 15.0)));
          },
          [=](double t) -> Vec3 {
            const double s = part(t);
            return d * (30.0 * s * s * (1.0 - s) * (1.0 - s) / (to - from));
          }};
}

Motion oscillation(const Vec3& amplitude, double frequency, double from, double to) {
  const double omega = 2.0 * std::numbers::pi * frequency;
  return {[=](double t) -> Vec3 { return amplitude * std::sin(omega * (std::clamp(t, from, to) - from)); },
          [=](double t) -> Vec3 {
            return t < from || t >= to ? Vec3(Vec3::Zero()) : Vec3(amplitude * omega * std::cos(omega * (t - from)));
          }};
}

Motion steadyMotion(const Vec3& v, double from, double to) {
  return {[=](double t) -> Vec3 { return v * (std::clamp(t, from, to) - from); },
          [=](double t) -> Vec3 { return t < from || t >= to ? Vec3(Vec3::Zero()) : v; }};
}

Motion startingAt(const Vec3& x, const Motion& about) {
  return {[x, move = about.position](double t) -> Vec3 { return x + move(t); }, about.velocity};
}

ModelExternalForce externalForce(std::vector<int> nodes, const Vec3& F, double from, double to, double frequency) {
  ModelExternalForce force;
  force.nodes = std::move(nodes);
  if (from > 0.0) force.times.push_back(from);
  if (std::isfinite(to)) force.times.push_back(to);
  const int begin = from > 0.0 ? 1 : 0;  // the segment in which the force acts
  const double omega = 2.0 * std::numbers::pi * frequency;
  force.force = [=](double t, int segment) -> Vec3 {
    if (segment != begin) return Vec3::Zero();
    return frequency > 0.0 ? Vec3(F * std::sin(omega * (t - from))) : F;
  };
  return force;
}

}  // namespace muelle::engine
