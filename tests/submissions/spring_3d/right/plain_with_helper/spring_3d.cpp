#include "spring_3d.h"

static double distance(const Vec3& p, const Vec3& q) { return (p - q).norm(); }

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) { return k * (L0 - distance(xa, xb)); }

Vec3 springDirection(const Vec3& xa, const Vec3& xb) {
  const double L = distance(xa, xb);
  Vec3 direction = Vec3::Zero();
  if (L > 0.0) direction = (xa - xb) / L;
  return direction;
}

Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return springDirection(xa, xb) * springForceMagnitude(xa, xb, k, L0);
}

Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < springs.size(); i++) {
    sum += springForce(x, springs[i].x, springs[i].k, springs[i].L0);
  }
  Vec3 a = sum / m;
  a[2] -= g;
  return a;
}
