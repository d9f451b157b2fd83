#include "spring_3d.h"

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) {
  const double L = (xb - xa).stableNorm();
  return L > L0 ? -(k * (L - L0)) : k * (L0 - L);
}

Vec3 springDirection(const Vec3& xa, const Vec3& xb) {
  if (xa == xb) return Vec3::Zero();
  // Scale the longest component to 1 first, then take the norm of what is left.
  const Vec3 r = xa - xb;
  const Vec3 scaled = r / r.lpNorm<Eigen::Infinity>();
  return scaled / scaled.norm();
}

Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return springForceMagnitude(xb, xa, k, L0) * -springDirection(xb, xa);
}

// Forces of the springs first..last-1: half of them, and the other half.
static Vec3 forceOf(const Vec3& x, std::span<const Attachment> springs) {
  if (springs.empty()) return Vec3::Zero();
  if (springs.size() == 1) return springForce(x, springs[0].x, springs[0].k, springs[0].L0);
  const std::size_t half = springs.size() / 2;
  return forceOf(x, springs.subspan(half)) + forceOf(x, springs.first(half));
}

Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  return forceOf(x, springs) / m - g * Vec3::UnitZ();
}
