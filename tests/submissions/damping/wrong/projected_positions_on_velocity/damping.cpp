// loses: ProjectedDamping, PairLaws, ProjectedMotion; misconception: projected_exchanged
// thought: unit vector of the velocity instead of the spring
#include "damping.h"

Vec3 nodeDamping(const Vec3& va, double d) {
  return -d * va;
}

Vec3 relativeDamping(const Vec3& va, const Vec3& vb, double d) {
  Vec3 v = va - vb;
  return -d * v;
}

Vec3 projectedDamping(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
  Vec3 r = xa - xb;
  Vec3 v = va - vb;
  double speed = v.norm();
  if (speed == 0) return Vec3::Zero();
  Vec3 u = v / speed;
  return -d * r.dot(u) * u;
}
