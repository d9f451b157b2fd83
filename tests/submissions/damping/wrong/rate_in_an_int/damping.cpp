// loses: ProjectedDamping, PairLaws, ProjectedMotion; misconception: none
#include "damping.h"

Vec3 nodeDamping(const Vec3& va, double d) { return -d * va; }

Vec3 relativeDamping(const Vec3& va, const Vec3& vb, double d) { return -d * (va - vb); }

Vec3 projectedDamping(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
  const Vec3 r = xa - xb, v = va - vb;
  const double L = r.norm();
  if (L == 0) return Vec3::Zero();
  int rate = 0;
  for (int i = 0; i < 3; ++i) rate += v[i] * r[i] / L;
  return -d * rate * r / L;
}
