#include "damping.h"

template <typename Vector>
Vector projected(const Vector& what, const Vector& onto) {
  const auto n = onto.stableNorm();
  if (n == 0) return Vector::Zero();
  const Vector unit = onto / n;
  return unit.dot(what) * unit;
}

Vec3 nodeDamping(const Vec3& va, double d) { return Vec3::Zero() - d * va; }

Vec3 relativeDamping(const Vec3& va, const Vec3& vb, double d) { return Vec3::Zero() - d * (va - vb); }

Vec3 projectedDamping(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
  return projected<Vec3>(relativeDamping(va, vb, d), xa - xb);
}
