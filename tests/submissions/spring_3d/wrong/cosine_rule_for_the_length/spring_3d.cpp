// loses: Magnitude, Direction, ShortSpring; misconception: edge or threshold
// thought: |a|^2 + |b|^2 - 2 a.b; far from the origin nothing is left
#include "spring_3d.h"

namespace {
double distanceOf(const Vec3& p, const Vec3& q) {
  const double squared = p.dot(p) + q.dot(q) - 2 * p.dot(q);
  return squared > 0 ? std::sqrt(squared) : 0.0;
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
  double ax = 0.0, ay = 0.0, az = -g;
  for (std::size_t i = 0; i < springs.size(); ++i) {
    const Vec3 f = springForce(x, springs[i].x, springs[i].k, springs[i].L0);
    ax += f[0] / m;
    ay += f[1] / m;
    az += f[2] / m;
  }
  return Vec3(ax, ay, az);
}
