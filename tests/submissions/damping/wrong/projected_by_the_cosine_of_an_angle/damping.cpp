// loses: ProjectedDamping, ProjectedMotion; misconception: missing_guard
// thought: |v| cos(angle): 0/0 when the ends move as one
#include "damping.h"

Vec3 nodeDamping(const Vec3& va, double d) {
  return -d * va;
}

Vec3 relativeDamping(const Vec3& va, const Vec3& vb, double d) {
  Vec3 v = va - vb;
  return -d * v;
}

Vec3 projectedDamping(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
  Vec3 r = xa - xb;
  double L = r.norm();
  if (L == 0) return Vec3::Zero();
  Vec3 v = va - vb;
  double cosine = v.dot(r) / (v.norm() * L);
  return -d * v.norm() * cosine * r / L;
}
