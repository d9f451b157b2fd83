// loses: Magnitude; misconception: halved
#include "spring_3d.h"

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) {
  const double deformation = (xa - xb).norm() - L0;
  return -0.5 * k * deformation;
}

Vec3 springDirection(const Vec3& xa, const Vec3& xb) {
  const double L = (xa - xb).norm();
  if (L == 0) return Vec3::Zero();
  return (xa - xb) / L;
}

Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0) {
  const double mag = springForceMagnitude(xa, xb, k, L0);
  const Vec3 dir = springDirection(xa, xb);
  return mag * dir;
}

Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  Vec3 total = Vec3::Zero();
  for (const Attachment& s : springs) total += springForce(x, s.x, s.k, s.L0);
  total.z() -= m * g;
  return total / m;
}
