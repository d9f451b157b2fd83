// loses: NodeAcceleration, ElasticPendulum; misconception: first_spring_only or first_only
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

Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  Vec3 force(0, 0, -m * g);
  for (auto s = springs.begin(); s != springs.end(); ++s) {
    force += springForce(x, s->x, s->k, s->L0);
    return force / m;
  }
  return force / m;
}
