// loses: NodeAcceleration, ElasticPendulum; misconception: wrong_sign or swapped_arguments
#include "spring_3d.h"

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) {
  const Vec3 r = xa - xb;
  return -k * (r.norm() - L0);
}

Vec3 springDirection(const Vec3& xa, const Vec3& xb) {
  const Vec3 r = xa - xb;
  if (r.isZero(0)) return Vec3::Zero();
  return r / r.norm();
}

Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return springForceMagnitude(xa, xb, k, L0) * springDirection(xa, xb);
}

Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  Vec3 F = Vec3(0, 0, -1) * m * g;
  for (const Attachment& s : springs) F += springForce(s.x, x, s.k, s.L0);  // from the fixed end to the node
  return F / m;
}
