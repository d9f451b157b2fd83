// loses: ProjectedDamping, ShortSpring, PairLaws, ProjectedMotion; misconception: not_projected
#include "damping.h"

Vec3 nodeDamping(const Vec3& va, double d) { return -d * va; }

Vec3 relativeDamping(const Vec3& va, const Vec3& vb, double d) { return -d * (va - vb); }

Vec3 projectedDamping(const Vec3&, const Vec3&, const Vec3& va, const Vec3& vb, double d) {
  return relativeDamping(va, vb, d);
}
