#include "spring_3d.h"

#include <numeric>

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) {
  const Vec3 d = xa - xb;
  return k * L0 - k * std::sqrt(d.dot(d));
}

Vec3 springDirection(const Vec3& xa, const Vec3& xb) {
  if (xa == xb) return Vec3::Zero();
  return (xa - xb) / (xa - xb).norm();
}

Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return springForceMagnitude(xa, xb, k, L0) * springDirection(xa, xb);
}

Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  const Vec3 pull =
      std::accumulate(springs.begin(), springs.end(), Vec3(0, 0, 0), [&x](const Vec3& before, const Attachment& s) {
        return Vec3(before + springForce(x, s.x, s.k, s.L0));
      });
  return Vec3(0, 0, -g) + pull / m;
}
