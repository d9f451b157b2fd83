// loses: Direction, NodeAcceleration, ElasticPendulum; misconception: not_normalised or gravity_along_y
// two mistakes: the direction is the difference itself, and y points up
#include "spring_3d.h"

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) {
  const double L = (xa - xb).norm();
  return -k * (L - L0);
}

Vec3 springDirection(const Vec3& xa, const Vec3& xb) { return xa - xb; }

Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return springForceMagnitude(xa, xb, k, L0) * springDirection(xa, xb);
}

Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  const Vec3 gravity(0, -g, 0);
  Vec3 a = gravity;
  for (const Attachment& s : springs) a += springForce(x, s.x, s.k, s.L0) / m;
  return a;
}
