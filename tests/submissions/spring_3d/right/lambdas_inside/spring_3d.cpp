#include "spring_3d.h"

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) {
  const auto hooke = [k](double deformation) { return -k * deformation; };
  return hooke((xa - xb).norm() - L0);
}

Vec3 springDirection(const Vec3& xa, const Vec3& xb) {
  const auto unit = [](const Vec3& v) -> Vec3 {
    const double n = v.norm();
    if (n > 0) return v / n;
    return v;
  };
  return unit(xa - xb);
}

Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return springForceMagnitude(xa, xb, k, L0) * springDirection(xa, xb);
}

Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  Vec3 a = Vec3::Zero();
  std::for_each(springs.begin(), springs.end(),
                [&](const Attachment& s) { a += springForce(x, s.x, s.k, s.L0) / m; });
  a.z() -= g;
  return a;
}
