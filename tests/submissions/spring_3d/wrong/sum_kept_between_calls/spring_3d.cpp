// loses: ZeroLength, ShortSpring, NodeAcceleration, ElasticPendulum; misconception: stateful
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
  const Vec3 u = springDirection(xa, xb);
  const double f = springForceMagnitude(xa, xb, k, L0);
  return {f * u.x(), f * u.y(), f * u.z()};
}

static Vec3 total(0, 0, 0);

Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  for (auto s = springs.begin(); s != springs.end(); ++s) total += springForce(x, s->x, s->k, s->L0);
  return total / m + Vec3(0, 0, -g);
}
