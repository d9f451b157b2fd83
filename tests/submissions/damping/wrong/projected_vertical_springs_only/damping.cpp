// loses: ProjectedDamping, ShortSpring, PairLaws, ProjectedMotion; misconception: projected_vertical
#include "damping.h"

Vec3 nodeDamping(const Vec3& va, double d) {
  return -d * va;
}

Vec3 relativeDamping(const Vec3& va, const Vec3& vb, double d) {
  Vec3 v = va - vb;
  return -d * v;
}

Vec3 projectedDamping(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
  if (xa == xb) return Vec3::Zero();
  return Vec3(0, 0, -d * (va[2] - vb[2]));
}
