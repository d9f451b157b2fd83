// loses: ZeroLength, ShortSpring, NodeAcceleration, ElasticPendulum; misconception: whole_numbers
// the mass is put into an int: below 1 kg it divides by zero
#include "spring_3d.h"

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) { return -k * ((xb - xa).norm() - L0); }

Vec3 springDirection(const Vec3& xa, const Vec3& xb) {
  const double L = (xb - xa).norm();
  if (L == 0) return Vec3::Zero();
  return -(xb - xa) / L;
}

Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return springForceMagnitude(xa, xb, k, L0) * springDirection(xa, xb);
}

Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  int mass = m;
  Vec3 force = Vec3::Zero();
  for (const Attachment& s : springs) force += springForce(x, s.x, s.k, s.L0);
  return force / mass + Vec3(0, 0, -g);
}
