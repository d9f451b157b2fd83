// loses: NodeAcceleration; misconception: none
// thought: a cube has eight corners
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
  std::array<Vec3, 8> forces;
  forces.fill(Vec3::Zero());
  for (std::size_t i = 0; i < std::min(springs.size(), forces.size()); ++i) {
    forces[i] = springForce(x, springs[i].x, springs[i].k, springs[i].L0);
  }
  Vec3 sum(0, 0, -m * g);
  for (const Vec3& f : forces) sum += f;
  return sum / m;
}
