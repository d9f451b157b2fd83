// loses: ProjectedDamping, ShortSpring, PairLaws, ProjectedMotion; misconception: none
#include "damping.h"

static Vec3 fromTo(const Vec3& a, const Vec3& b) { return b - a; }

Vec3 nodeDamping(const Vec3& va, double d) { return -d * va; }

Vec3 relativeDamping(const Vec3& va, const Vec3& vb, double d) { return -d * (va - vb); }

Vec3 projectedDamping(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
  const double L = (xa - xb).norm();
  if (L == 0.0) return Vec3::Zero();
  auto u = fromTo(xb, xa) / L;
  const double lengthRate = (va - vb).dot(u);
  return -d * lengthRate * u;
}
