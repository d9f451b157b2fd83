// loses: NodeAcceleration; misconception: none
// forces are kept in an array of 16, what is beyond is dropped; 40 springs may come
#include "spring_3d.h"

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) { return -k * ((xa - xb).norm() - L0); }

Vec3 springDirection(const Vec3& xa, const Vec3& xb) {
  const double L = (xa - xb).norm();
  if (L == 0) return Vec3::Zero();
  return (xa - xb) / L;
}

Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return springForceMagnitude(xa, xb, k, L0) * springDirection(xa, xb);
}

Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  const std::size_t most = 16;
  std::array<Vec3, most> forces;
  const std::size_t n = std::min(springs.size(), most);
  for (std::size_t i = 0; i < n; ++i) forces[i] = springForce(x, springs[i].x, springs[i].k, springs[i].L0);
  Vec3 sum(0, 0, -m * g);
  for (std::size_t i = 0; i < n; ++i) sum += forces[i];
  return sum / m;
}
