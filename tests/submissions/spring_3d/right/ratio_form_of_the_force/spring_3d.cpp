#include "spring_3d.h"

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) {
  const double L = (xa - xb).norm();
  return k * L0 - k * L;
}

Vec3 springDirection(const Vec3& xa, const Vec3& xb) {
  Vec3 dir = xa - xb;
  double L = dir.norm();
  if (L == 0) return Vec3(0, 0, 0);
  dir /= L;
  return dir;
}

Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0) {
  const Vec3 r = xa - xb;
  const double L = r.norm();
  if (L == 0) return Vec3(0, 0, 0);
  return k * ((L0 - L) / L * r);
}

Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  Vec3 force(0, 0, -g * m);
  int n = static_cast<int>(springs.size());
  while (n > 0) {  // from the back
    n--;
    force = force + springForce(x, springs[n].x, springs[n].k, springs[n].L0);
  }
  return 1 / m * force;
}
