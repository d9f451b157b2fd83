// loses: NodeDamping, NodeMotion; misconception: squared or argument_twice or factor_too_many
// -d is multiplied into the velocity, and into the result again; right for d = 0 and in size for d = 1
#include "damping.h"

Vec3 nodeDamping(const Vec3& va, double d) {
  const Vec3 damped = d * va;
  return -d * damped;
}

Vec3 relativeDamping(const Vec3& va, const Vec3& vb, double d) { return -d * (va - vb); }

Vec3 projectedDamping(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
  const double L = (xa - xb).norm();
  if (L == 0) return Vec3::Zero();
  const Vec3 u = (xa - xb) / L;
  return -d * (va - vb).dot(u) * u;
}
