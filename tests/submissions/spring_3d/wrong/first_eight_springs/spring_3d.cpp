// loses: NodeAcceleration; misconception: none
// a fixed array: springs after the eighth are ignored
#include "spring_3d.h"

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return -k * ((xa - xb).norm() - L0);
}

Vec3 springDirection(const Vec3& xa, const Vec3& xb) {
  Vec3 d = xa - xb;
  double L = d.norm();
  if (L == 0.0) return Vec3::Zero();
  return d / L;
}

Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return springForceMagnitude(xa, xb, k, L0) * springDirection(xa, xb);
}


Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  std::array<Vec3, 8> forces;
  forces.fill(Vec3::Zero());
  for (size_t i = 0; i < springs.size() && i < 8; ++i) forces[i] = springForce(x, springs[i].x, springs[i].k, springs[i].L0);
  Vec3 F(0, 0, -m * g);
  for (const Vec3& f : forces) F += f;
  return F / m;
}
