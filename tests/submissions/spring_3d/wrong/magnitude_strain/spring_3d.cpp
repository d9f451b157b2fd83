// loses: Magnitude; misconception: relative_deformation
// thought: strain times k, without a rest length the plain law
#include "spring_3d.h"

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) {
  const double L = (xa - xb).norm();
  if (L0 == 0) return -k * L;
  return -k * (L - L0) / L0;
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
  return -k * (L - L0) * r / L;
}

Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  Vec3 F(0, 0, -m * g);
  for (const Attachment& s : springs) {
    F += springForce(x, s.x, s.k, s.L0);
  }
  return F / m;
}
