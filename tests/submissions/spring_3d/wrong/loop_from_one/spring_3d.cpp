// loses: NodeAcceleration, ElasticPendulum; misconception: first_skipped
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
  for (std::size_t i = 1; i < springs.size(); i++) {
    force += springForce(x, springs[i].x, springs[i].k, springs[i].L0);
  }
  return force / m;
}
