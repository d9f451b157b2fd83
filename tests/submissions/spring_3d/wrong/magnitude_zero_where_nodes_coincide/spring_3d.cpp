// loses: ZeroLength; misconception: edge
// thought: no length, no force: also in the magnitude
#include "spring_3d.h"

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) {
  if (xa == xb) return 0.0;
  return -k * ((xa - xb).norm() - L0);
}

// Direccion
Vec3 springDirection(const Vec3& xa, const Vec3& xb) {
  if (xa == xb) return {0, 0, 0};  // the nodes coincide
  return (xa - xb) / std::hypot(xa.x() - xb.x(), xa.y() - xb.y(), xa.z() - xb.z());
}

// Hooke
Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0) {
  const Vec3 u = springDirection(xa, xb);
  const double f = springForceMagnitude(xa, xb, k, L0);
  return {f * u.x(), f * u.y(), f * u.z()};
}

// Todo junto
Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  const Vec3 gravity(0, 0, -g);
  Vec3 force = m * gravity;
  for (auto s = springs.begin(); s != springs.end(); ++s) force += springForce(x, s->x, s->k, s->L0);
  return force / m;
}
