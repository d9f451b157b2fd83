// loses: ShortSpring, NodeAcceleration, ElasticPendulum; misconception: threshold or first_spring_only or first_only
#include "spring_3d.h"

namespace {
// distance of two points
double distanceOf(const Vec3& p, const Vec3& q) {
  const double dx = p[0] - q[0], dy = p[1] - q[1], dz = p[2] - q[2];
  return std::sqrt(dx * dx + dy * dy + dz * dz);
}
}  // namespace

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) {
  const double stretch = distanceOf(xa, xb) - L0;
  return -k * stretch;
}

Vec3 springDirection(const Vec3& xa, const Vec3& xb) {
  const double d = distanceOf(xa, xb);
  if (d < 1e-6) return Vec3(0, 0, 0);
  return (xa - xb) / d;
}

Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return springForceMagnitude(xa, xb, k, L0) * springDirection(xa, xb);
}

Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  Vec3 a(0, 0, -g);
  if (springs.size() > 0) a += springForce(x, springs[0].x, springs[0].k, springs[0].L0) / m;
  return a;
}
