// loses: ProjectedDamping, PairLaws, ProjectedMotion; misconception: projected_component_missing
// thought: i < 2
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
  double L = r.norm();
  if (L == 0) return Vec3::Zero();
  double rate = 0;
  for (int i = 0; i < 2; i++) rate += (va[i] - vb[i]) * r[i] / L;
  return -d * rate * r / L;
}
