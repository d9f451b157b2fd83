#include "spring_3d.h"

#include <numeric>

// Eigen's own normalized(), which leaves a zero vector alone, and an algorithm for the sum.

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) { return k * (L0 - (xb - xa).norm()); }

Vec3 springDirection(const Vec3& xa, const Vec3& xb) { return (xa - xb).normalized(); }

Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0) {
  const Vec3 d = xa - xb;
  return -k * d + k * L0 * d.normalized();
}

Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  const Vec3 weight = -m * g * Vec3::UnitZ();
  const Vec3 total = std::accumulate(springs.begin(), springs.end(), weight, [&](const Vec3& sum, const Attachment& s) {
    return Vec3(sum + springForce(x, s.x, s.k, s.L0));
  });
  return total / m;
}
