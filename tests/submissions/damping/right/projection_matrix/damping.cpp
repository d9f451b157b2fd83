#include "damping.h"

using muelle::Mat3;

Vec3 nodeDamping(const Vec3& va, double d) {
  const Mat3 D = d * Mat3::Identity();
  return -D * va;
}

Vec3 relativeDamping(const Vec3& va, const Vec3& vb, double d) { return nodeDamping(va, d) - nodeDamping(vb, d); }

Vec3 projectedDamping(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
  const Vec3 r = xa - xb;
  const double squaredLength = r.squaredNorm();
  if (squaredLength == 0.0) return Vec3(0, 0, 0);
  const Mat3 P = r * r.transpose() / squaredLength;
  return P * relativeDamping(va, vb, d);
}
