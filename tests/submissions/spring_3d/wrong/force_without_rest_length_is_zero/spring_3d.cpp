// loses: HookeForce; misconception: edge
// thought: L0 = 0: no spring
#include "spring_3d.h"

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return k * (L0 - (xa - xb).norm());
}

Vec3 springDirection(const Vec3& xa, const Vec3& xb) {
  const auto n = (xa - xb).norm();
  return n > 0.0 ? Vec3((xa - xb) / n) : Vec3(Vec3::Zero());
}

Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0) {
  if (L0 == 0.0) return Vec3::Zero();
  return springForceMagnitude(xa, xb, k, L0) * springDirection(xa, xb);
}

Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  Vec3 elastic = Vec3::Zero();
  for (const auto& [other, k, rest] : springs) elastic += springForce(x, other, k, rest);
  return elastic / m - Vec3(0, 0, g);
}
