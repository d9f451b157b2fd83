#include "damping.h"

namespace oracle {

Vec3 nodeDamping(const Vec3& va, double d) { return {-d * va.x(), -d * va.y(), -d * va.z()}; }

Vec3 relativeDamping(const Vec3& va, const Vec3& vb, double d) { return nodeDamping(va, d) - nodeDamping(vb, d); }

// Without a unit vector: with r = xa - xb, the force is -d (r . v) r / (r . r).
Vec3 projectedDamping(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
  const Vec3 r = xa - xb;
  const double squaredLength = r.dot(r);
  if (!(squaredLength > 0.0)) return Vec3::Zero();
  return r * (-d * (r.dot(va) - r.dot(vb)) / squaredLength);
}

}  // namespace oracle
