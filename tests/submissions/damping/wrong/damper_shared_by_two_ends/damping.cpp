// loses: RelativeDamping, RelativeMotion; misconception: relative_half or halved
// "each end gets its half"; the projection has its own difference
#include "damping.h"

Vec3 nodeDamping(const Vec3& va, double d) { return -d * va; }

Vec3 relativeDamping(const Vec3& va, const Vec3& vb, double d) { return -d / 2 * (va - vb); }

Vec3 projectedDamping(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
  const double L = (xa - xb).norm();
  if (L == 0) return Vec3::Zero();
  const Vec3 dir = (xa - xb) / L;
  return -d * dir * dir.dot(va - vb);
}
