// loses: ZeroLength; misconception: missing_guard
#include "spring_3d.h"

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return -k * ((xa - xb).norm() - L0);
}

Vec3 springDirection(const Vec3& xa, const Vec3& xb) {
  const Vec3 r = xa - xb;
  const double L = r.norm();
  return r / L;
}

Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return springForceMagnitude(xa, xb, k, L0) * springDirection(xa, xb);
}

Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  Vec3 a(0, 0, -g);
  for (const auto& [end, k, L0] : springs) a += springForce(x, end, k, L0) / m;
  return a;
}
