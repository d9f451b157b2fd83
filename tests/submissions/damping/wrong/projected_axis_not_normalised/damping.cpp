// loses: ProjectedDamping, ProjectedMotion; misconception: not_normalised
#include "damping.h"

Vec3 nodeDamping(const Vec3& va, double d) {
  return Vec3(-d * va[0], -d * va[1], -d * va[2]);
}

Vec3 relativeDamping(const Vec3& va, const Vec3& vb, double d) {
  return Vec3(d * (vb[0] - va[0]), d * (vb[1] - va[1]), d * (vb[2] - va[2]));
}

Vec3 projectedDamping(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
  const Vec3 r = xa - xb;
  const double product = r[0] * (va[0] - vb[0]) + r[1] * (va[1] - vb[1]) + r[2] * (va[2] - vb[2]);
  return -d * product * r;
}
