// loses: ProjectedDamping, PairLaws, ProjectedMotion; misconception: scalar_speed
#include "damping.h"

Vec3 nodeDamping(const Vec3& va, double d) { return -d * va; }

Vec3 relativeDamping(const Vec3& va, const Vec3& vb, double d) {
  const Vec3 v = va - vb;
  return -d * v;
}

Vec3 projectedDamping(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
  const double L = (xa - xb).norm();
  if (L == 0) return Vec3::Zero();
  const Vec3 u = (xa - xb) / L;
  const double speed = (va - vb).norm();
  return -d * speed * u;
}
