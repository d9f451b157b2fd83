// loses: ShortSpring; misconception: softened_length
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
  double L2 = r.squaredNorm() + 1e-16;
  return -d * (va - vb).dot(r) / L2 * r;
}
