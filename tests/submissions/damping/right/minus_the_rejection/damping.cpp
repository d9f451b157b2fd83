#include "damping.h"

namespace {

// part of v across the unit vector u
Vec3 across(const Vec3& v, const Vec3& u) { return v - v.dot(u) * u; }

}  // namespace

Vec3 nodeDamping(const Vec3& va, double d) { return d * -va; }

Vec3 relativeDamping(const Vec3& va, const Vec3& vb, double d) { return d * -(va - vb); }

Vec3 projectedDamping(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
  const double L = (xb - xa).norm();
  if (L == 0) return Vec3::Zero();
  const Vec3 u = (xb - xa) / L;
  const Vec3 v = va - vb;
  const Vec3 along = v - across(v, u);
  return -d * along;
}
