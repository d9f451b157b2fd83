#include "spring_3d.h"

static Vec3 sumFrom(std::size_t first, const Vec3& x, const std::vector<Attachment>& list) {
  if (first == list.size()) return Vec3::Zero();
  const Attachment& s = list[first];
  return springForce(x, s.x, s.k, s.L0) + sumFrom(first + 1, x, list);
}

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) {
  const double L = (xb - xa).norm();
  if (L == L0) return 0.0;                    // at rest
  return L > L0 ? -k * (L - L0) : k * (L0 - L);  // stretched : compressed
}

Vec3 springDirection(const Vec3& xa, const Vec3& xb) {
  const double L = (xb - xa).norm();
  if (L != 0) return -(xb - xa) / L;
  return Vec3::Zero();
}

Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return springForceMagnitude(xa, xb, k, L0) * springDirection(xa, xb);
}

Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  const Vec3 weight = {0, 0, -m * g};
  return (weight + sumFrom(0, x, springs)) / m;
}
