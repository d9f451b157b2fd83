// loses: NodeDamping, RelativeDamping, NodeMotion, RelativeMotion; misconception: node_wrong_sign or relative_wrong_sign
// two mistakes: no minus in the first two; the third has its own formula
#include "damping.h"

Vec3 nodeDamping(const Vec3& va, double d) { return d * va; }

Vec3 relativeDamping(const Vec3& va, const Vec3& vb, double d) { return d * (va - vb); }

Vec3 projectedDamping(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
  const Vec3 r = xa - xb;
  const double L = r.norm();
  if (L == 0) return Vec3::Zero();
  return -d * ((va - vb).dot(r / L)) * (r / L);
}
