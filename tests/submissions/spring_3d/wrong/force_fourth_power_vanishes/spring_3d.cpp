// loses: ZeroLength, ShortSpring; misconception: threshold
// thought: the factors of r/L under one root; no case for 0
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
  const Vec3 r = xa - xb;
  const double L = distanceOf(xa, xb);
  const double fourth = r.squaredNorm() * r.squaredNorm();  // L^4
  return -k * (L - L0) * r * (L / std::sqrt(fourth));
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
