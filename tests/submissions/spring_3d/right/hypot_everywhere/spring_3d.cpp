#include "spring_3d.h"

namespace {
// hypot neither overflows nor underflows
double dist(const Vec3& p, const Vec3& q) { return std::hypot(p.x() - q.x(), p.y() - q.y(), p.z() - q.z()); }
}  // namespace

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) { return -k * (dist(xa, xb) - L0); }

Vec3 springDirection(const Vec3& xa, const Vec3& xb) {
  const double d = dist(xa, xb);
  if (!(d > 0.0)) return {0.0, 0.0, 0.0};
  return {(xa.x() - xb.x()) / d, (xa.y() - xb.y()) / d, (xa.z() - xb.z()) / d};
}

Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return springDirection(xa, xb) * springForceMagnitude(xa, xb, k, L0);
}

Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  Vec3 a(0.0, 0.0, -g);
  for (const auto& [end, k, rest] : springs) a += springForce(x, end, k, rest) / m;
  return a;
}
