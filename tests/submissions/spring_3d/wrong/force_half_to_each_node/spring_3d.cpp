// loses: HookeForce; misconception: halved
// thought: each node takes its half
#include "spring_3d.h"

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) {
  Vec3 r = xa - xb;
  double L = r.norm();
  return -k * (L - L0);
}

Vec3 springDirection(const Vec3& xa, const Vec3& xb) {
  Vec3 r = xa - xb;
  double L = r.norm();
  if (L == 0) {
    return Vec3::Zero();
  }
  return r / L;
}

Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0) {
  const Vec3 r = xa - xb;
  const double L = r.norm();
  if (L == 0) return Vec3::Zero();
  return -k * (L - L0) * r / (2 * L);
}

Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  Vec3 F(0, 0, -m * g);
  for (const Attachment& s : springs) {
    F += springForce(x, s.x, s.k, s.L0);
  }
  return F / m;
}
