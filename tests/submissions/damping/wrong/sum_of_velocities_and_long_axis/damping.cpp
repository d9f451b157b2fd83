// loses: RelativeDamping, ProjectedDamping, PairLaws, RelativeMotion, ProjectedMotion; misconception: relative_adds or not_normalised
// two mistakes: va + vb, and xa - xb in place of its unit vector
#include "damping.h"

Vec3 nodeDamping(const Vec3& va, double d) { return -d * va; }

Vec3 relativeDamping(const Vec3& va, const Vec3& vb, double d) { return -d * (va + vb); }

Vec3 projectedDamping(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
  Vec3 axis = xa - xb;
  double speed = (va - vb).dot(axis);
  return -d * speed * axis;
}
