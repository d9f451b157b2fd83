// loses: HookeForce, ThirdLaw, Equivariance; misconception: each_axis_alone
#include "spring_3d.h"

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) { return -k * ((xa - xb).norm() - L0); }

Vec3 springDirection(const Vec3& xa, const Vec3& xb) {
  const double L = (xa - xb).norm();
  if (L == 0) return Vec3::Zero();
  return (xa - xb) / L;
}

Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0) {
  Vec3 F = Vec3::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    const double d = xa[axis] - xb[axis];
    if (d != 0) F[axis] = -k * (std::abs(d) - L0) * d / std::abs(d);
  }
  return F;
}

Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  Vec3 force(0, 0, -m * g);
  for (const Attachment& s : springs) force += springForce(x, s.x, s.k, s.L0);
  return force / m;
}
