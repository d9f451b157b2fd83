#include "spring_3d.h"

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) {
  const Vec3 ab = xb - xa;
  return k * (L0 - ab.stableNorm());
}

Vec3 springDirection(const Vec3& xa, const Vec3& xb) {
  Vec3 e = xa - xb;
  if (e == Vec3::Zero()) return e;
  e.stableNormalize();
  return e;
}

Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0) {
  Vec3 F = springDirection(xa, xb);
  F *= springForceMagnitude(xa, xb, k, L0);
  return F;
}

Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  Vec3 total(0, 0, 0);
  total[2] -= m * g;
  for (auto& s : springs) total += springForce(x, s.x, s.k, s.L0);
  total /= m;
  return total;
}
