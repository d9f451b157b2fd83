#include "spring_3d.h"

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return std::fma(-k, (xa - xb).norm(), k * L0);
}

Vec3 springDirection(const Vec3& xa, const Vec3& xb) {
  const double L = (xa - xb).stableNorm();
  return L > 0 ? Vec3((xa - xb) / L) : Vec3(0, 0, 0);
}

Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return springForceMagnitude(xa, xb, k, L0) * springDirection(xa, xb);
}

Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  Vec3 sum(0, 0, -m * g), lost(0, 0, 0);
  for (const Attachment& s : springs) {
    const Vec3 y = springForce(x, s.x, s.k, s.L0) - lost;
    const Vec3 t = sum + y;
    lost = (t - sum) - y;
    sum = t;
  }
  return sum / m;
}
