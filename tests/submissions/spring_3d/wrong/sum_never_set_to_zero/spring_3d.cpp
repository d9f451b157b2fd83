// loses: ZeroLength, ShortSpring, NodeAcceleration, ElasticPendulum; misconception: never_written
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
  if (d == 0.0) return Vec3(0, 0, 0);
  return Vec3((xa[0] - xb[0]) / d, (xa[1] - xb[1]) / d, (xa[2] - xb[2]) / d);
}

Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return springForceMagnitude(xa, xb, k, L0) * springDirection(xa, xb);
}

Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  Vec3 total;
  for (std::size_t i = 0; i < springs.size(); ++i) {
    total += springForce(x, springs[i].x, springs[i].k, springs[i].L0);
  }
  total[2] -= m * g;
  return total / m;
}
