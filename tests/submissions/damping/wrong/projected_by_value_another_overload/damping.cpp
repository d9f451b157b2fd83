// loses: ProjectedDamping, ShortSpring, PairLaws, ProjectedMotion; misconception: none
// thought: took the vectors by value: the declared function stays undefined
#include "damping.h"

Vec3 nodeDamping(const Vec3& va, double d) {
  return -d * va;
}

Vec3 relativeDamping(const Vec3& va, const Vec3& vb, double d) {
  Vec3 v = va - vb;
  return -d * v;
}

Vec3 projectedDamping(Vec3 xa, Vec3 xb, Vec3 va, Vec3 vb, double d) {
  double L = (xa - xb).norm();
  if (L == 0) return Vec3::Zero();
  Vec3 u = (xa - xb) / L;
  return -d * (va - vb).dot(u) * u;
}
