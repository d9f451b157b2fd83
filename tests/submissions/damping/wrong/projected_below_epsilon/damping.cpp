// loses: ShortSpring; misconception: threshold
#include "damping.h"
#include <limits>

Vec3 nodeDamping(const Vec3& va, double d) { return -d * va; }

Vec3 relativeDamping(const Vec3& va, const Vec3& vb, double d) { return -d * (va - vb); }

Vec3 projectedDamping(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
  const double L = (xa - xb).norm();
  if (L < std::numeric_limits<double>::epsilon()) return Vec3::Zero();
  const Vec3 u = (xa - xb) / L;
  const double speed = (va - vb).dot(u);
  return -d * speed * u;
}
