// loses: ProjectedDamping, ProjectedMotion; misconception: not_normalised
#include "damping.h"

Vec3 nodeDamping(const Vec3& va, double d) { return -d * va; }

Vec3 relativeDamping(const Vec3& va, const Vec3& vb, double d) { return -d * (va - vb); }

Vec3 projectedDamping(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
  const Vec3 direction = xa - xb;
  return -d * (va - vb).dot(direction) * direction;
}
