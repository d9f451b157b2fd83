// loses: HookeForce, ThirdLaw, Equivariance; misconception: each_axis_alone
#include "spring_3d.h"

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) {
  const double L = (xa - xb).norm();
  return -k * (L - L0);
}

Vec3 springDirection(const Vec3& xa, const Vec3& xb) {
  const double L = (xa - xb).norm();
  if (L == 0) return Vec3::Zero();
  return (xa - xb) / L;
}

Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0) {
  Vec3 force;
  for (int i = 0; i < 3; ++i) {
    const double L = std::abs(xa[i] - xb[i]);
    force[i] = L == 0 ? 0 : -k * (L - L0) * (xa[i] - xb[i]) / L;
  }
  return force;
}

Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  Vec3 force = Vec3(0, 0, -m * g);
  for (const Attachment& spring : springs) force += springForce(x, spring.x, spring.k, spring.L0);
  return force / m;
}
