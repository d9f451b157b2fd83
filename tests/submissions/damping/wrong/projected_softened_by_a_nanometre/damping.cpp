// loses: ProjectedDamping, ShortSpring; misconception: softened_length
#include "damping.h"

Vec3 nodeDamping(const Vec3& va, double d) {
  Vec3 force = va;
  force *= -d;
  return force;
}

Vec3 relativeDamping(const Vec3& va, const Vec3& vb, double d) {
  const Vec3 seenFromB = va - vb;
  return -d * seenFromB;
}

Vec3 projectedDamping(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
  const Vec3 u = (xa - xb) / ((xa - xb).norm() + 1e-9);
  return -d * u.dot(va - vb) * u;
}
