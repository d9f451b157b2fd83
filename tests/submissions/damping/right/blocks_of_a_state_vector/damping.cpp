#include "damping.h"

using muelle::Vec6;

static Vec6 both(const Vec3& a, const Vec3& b) {
  Vec6 ab;
  ab << a, b;
  return ab;
}

static Vec3 difference(const Vec6& ab) { return ab.head<3>() - ab.tail<3>(); }

Vec3 nodeDamping(const Vec3& va, double d) { return -d * both(va, va).head<3>(); }

Vec3 relativeDamping(const Vec3& va, const Vec3& vb, double d) { return -d * difference(both(va, vb)); }

Vec3 projectedDamping(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
  const Vec3 r = difference(both(xa, xb));
  const Vec3 v = difference(both(va, vb));
  const double L = std::sqrt(r.squaredNorm());
  if (L == 0) return Vec3::Zero();
  return -d / L * (v.dot(r) / L) * r;
}
