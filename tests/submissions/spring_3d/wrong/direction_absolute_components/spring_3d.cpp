// loses: Direction; misconception: absolute_value
#include "spring_3d.h"

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return k * (L0 - (xa - xb).norm());
}

Vec3 springDirection(const Vec3& xa, const Vec3& xb) {
  const Vec3 r = (xa - xb).cwiseAbs();
  const double n = r.norm();
  if (n == 0) return r;
  return r / n;
}

Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return springDirection(xa, xb) * springForceMagnitude(xa, xb, k, L0);
}

Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  Vec3 elastic = Vec3::Zero();
  for (const auto& [other, k, rest] : springs) elastic += springForce(x, other, k, rest);
  return elastic / m - Vec3(0, 0, g);
}
