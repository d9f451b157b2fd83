// loses: HookeForce, ThirdLaw, Equivariance; misconception: none
// thought: b is the ceiling, so the direction points down
#include "spring_3d.h"

// Magnitud
double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) {
  const double length = std::hypot(xa.x() - xb.x(), xa.y() - xb.y(), xa.z() - xb.z());
  const double deformation = length - L0;
  return -k * deformation;
}

// Direccion
Vec3 springDirection(const Vec3& xa, const Vec3& xb) {
  if (xa == xb) return {0, 0, 0};  // the nodes coincide
  return (xa - xb) / std::hypot(xa.x() - xb.x(), xa.y() - xb.y(), xa.z() - xb.z());
}

// Hooke
Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0) {
  Vec3 u = springDirection(xa, xb);
  if (u.z() > 0) u = -u;
  return springForceMagnitude(xa, xb, k, L0) * u;
}

// Todo junto
Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  const Vec3 gravity(0, 0, -g);
  Vec3 force = m * gravity;
  for (auto s = springs.begin(); s != springs.end(); ++s) force += springForce(x, s->x, s->k, s->L0);
  return force / m;
}
