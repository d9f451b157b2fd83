#include "spring_3d.h"

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return k * (L0 - (xa - xb).norm());
}

Vec3 springDirection(const Vec3& xa, const Vec3& xb) {
  const Vec3 r = xa - xb;
  const double l = r.norm();
  if (l == 0) return r;
  return r.array() / l;
}

Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return springForceMagnitude(xa, xb, k, L0) * springDirection(xa, xb);
}

Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  // one column per force, the last one is the weight
  const Eigen::Index n = static_cast<Eigen::Index>(springs.size());
  Eigen::Matrix3Xd all(3, n + 1);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Attachment& s = springs[static_cast<std::size_t>(i)];
    all.col(i) = springForce(x, s.x, s.k, s.L0);
  }
  all.col(n) = Vec3(0, 0, -m * g);
  return all.rowwise().sum() / m;
}
