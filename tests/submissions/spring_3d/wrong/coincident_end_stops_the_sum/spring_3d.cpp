// loses: ZeroLength; misconception: none
// break where continue was meant: the springs after one whose end is at x are lost
#include "spring_3d.h"

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) { return -k * ((xa - xb).norm() - L0); }

Vec3 springDirection(const Vec3& xa, const Vec3& xb) {
  const double L = (xa - xb).norm();
  if (L == 0) return Vec3::Zero();
  return (xa - xb) / L;
}

Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return springForceMagnitude(xa, xb, k, L0) * springDirection(xa, xb);
}

Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  Vec3 force(0, 0, -m * g);
  for (const Attachment& s : springs) {
    if (s.x == x) break;  // no direction, no force
    force += springForce(x, s.x, s.k, s.L0);
  }
  return force / m;
}
