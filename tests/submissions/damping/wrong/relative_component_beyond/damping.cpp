// loses: RelativeDamping, PairLaws, RelativeMotion; misconception: none
#include "damping.h"

Vec3 nodeDamping(const Vec3& va, double d) { return -d * va; }

Vec3 relativeDamping(const Vec3& va, const Vec3& vb, double d) {
  Vec3 force = Vec3::Zero();
  for (int i = 1; i <= 3; ++i) force[i] = -d * (va[i] - vb[i]);
  return force;
}

Vec3 projectedDamping(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
  const double L = (xa - xb).norm();
  if (L == 0.0) return Vec3::Zero();
  const Vec3 u = (xa - xb) / L;
  const double lengthRate = (va - vb).dot(u);
  return -d * lengthRate * u;
}
