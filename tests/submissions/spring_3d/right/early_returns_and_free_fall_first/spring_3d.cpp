#include "spring_3d.h"

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) {
  if (xa == xb) return k * L0;  // fully compressed
  return -k * ((xa - xb).norm() - L0);
}

Vec3 springDirection(const Vec3& xa, const Vec3& xb) {
  if (xa == xb) return Vec3::Zero();
  const Vec3 r = xa - xb;
  const double squared = r.x() * r.x() + r.y() * r.y() + r.z() * r.z();
  return r / std::sqrt(squared);
}

Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0) {
  if (xa == xb) return Vec3::Zero();
  if (L0 == 0) return -k * (xa - xb);  // a spring without rest length is linear
  return springForceMagnitude(xa, xb, k, L0) * springDirection(xa, xb);
}

Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  const Vec3 freeFall(0, 0, -g);
  if (springs.empty()) return freeFall;
  Vec3 sum = Vec3::Zero();
  for (const Attachment& s : springs) {
    if (s.x == x) continue;
    sum += springForce(x, s.x, s.k, s.L0);
  }
  return freeFall + sum / m;
}
