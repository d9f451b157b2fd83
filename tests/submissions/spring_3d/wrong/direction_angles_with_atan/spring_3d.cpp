// loses: Direction; misconception: none
// thought: spherical coordinates
#include "spring_3d.h"

// Magnitud
double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) {
  const double length = std::hypot(xa.x() - xb.x(), xa.y() - xb.y(), xa.z() - xb.z());
  const double deformation = length - L0;
  return -k * deformation;
}

// Direccion, by its two angles
Vec3 springDirection(const Vec3& xa, const Vec3& xb) {
  const Vec3 r = xa - xb;
  if (r.norm() == 0) return Vec3::Zero();
  const double horizontal = std::hypot(r.x(), r.y());
  const double phi = r.x() == 0 ? (r.y() < 0 ? -std::acos(0.0) : std::acos(0.0)) : std::atan(r.y() / r.x());
  const double theta = std::atan2(r.z(), horizontal);
  return {std::cos(theta) * std::cos(phi), std::cos(theta) * std::sin(phi), std::sin(theta)};
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
