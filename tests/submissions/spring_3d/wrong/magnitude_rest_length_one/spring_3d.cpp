// loses: Magnitude; misconception: missing_factor
#include "spring_3d.h"

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) {
  const double rest = 1.0;
  (void)L0;
  return -k * ((xa - xb).norm() - rest);
}

Vec3 springDirection(const Vec3& xa, const Vec3& xb) {
  const auto n = (xa - xb).norm();
  return n > 0.0 ? Vec3((xa - xb) / n) : Vec3(Vec3::Zero());
}

Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return springDirection(xa, xb) * springForceMagnitude(xa, xb, k, L0);
}

Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  Vec3 elastic = Vec3::Zero();
  for (const auto& [other, k, rest] : springs) elastic += springForce(x, other, k, rest);
  return elastic / m - Vec3(0, 0, g);
}
