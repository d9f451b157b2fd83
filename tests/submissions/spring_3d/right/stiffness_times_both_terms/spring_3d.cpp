#include "spring_3d.h"

// F = k L0 u - k r, because L u = r. No difference L - L0 anywhere in the force.

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return k * (L0 - std::sqrt((xa - xb).squaredNorm()));
}

Vec3 springDirection(const Vec3& xa, const Vec3& xb) {
  const Vec3 r = xa - xb;
  if (r.isZero(0.0)) return Vec3::Zero();
  return r / r.norm();
}

Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0) {
  const Vec3 r = xa - xb;
  return k * (L0 * springDirection(xa, xb) - r);
}

Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  Vec3 a = -g * Vec3::UnitZ();
  const double inverseMass = 1.0 / m;
  for (const Attachment& s : springs) a += inverseMass * springForce(x, s.x, s.k, s.L0);
  return a;
}
