#include "damping.h"

Vec3 nodeDamping(const Vec3& va, double d) { return Vec3(-d * va[0], -d * va[1], -d * va[2]); }

Vec3 relativeDamping(const Vec3& va, const Vec3& vb, double d) {
  Vec3 F;
  for (int i = 0; i < 3; i++) F[i] = d * (vb[i] - va[i]);
  return F;
}

Vec3 projectedDamping(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
  double L = std::hypot(xa[0] - xb[0], xa[1] - xb[1], xa[2] - xb[2]);
  Vec3 F(0, 0, 0);
  if (L > 0) {
    double rate = 0;
    for (int i = 0; i < 3; i++) rate += (va[i] - vb[i]) * ((xa[i] - xb[i]) / L);
    for (int i = 0; i < 3; i++) F[i] = -d * rate * ((xa[i] - xb[i]) / L);
  }
  return F;
}
