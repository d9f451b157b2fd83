#include "spring_3d.h"

// normalized() leaves a zero vector as it is, so L = 0 needs no case of its own.

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) {
  auto stretch = (xa - xb).norm() - L0;
  return -(k * stretch);
}

Vec3 springDirection(const Vec3& xa, const Vec3& xb) { return (xa - xb).normalized(); }

Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return springForceMagnitude(xa, xb, k, L0) * springDirection(xa, xb);
}

Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  Vec3 elastic = Vec3::Zero();
  for (auto it = springs.begin(); it != springs.end(); ++it) elastic += springForce(x, it->x, it->k, it->L0);
  return (elastic - m * g * Vec3::UnitZ()) / m;
}
