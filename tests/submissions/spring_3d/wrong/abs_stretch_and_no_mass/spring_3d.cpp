// loses: Magnitude, NodeAcceleration, ElasticPendulum; misconception: unsigned_deformation or absolute_value or missing_mass
// two mistakes: |L - L0| in the magnitude, and the node's force is returned
#include "spring_3d.h"

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return -k * std::abs((xa - xb).norm() - L0);
}

Vec3 springDirection(const Vec3& xa, const Vec3& xb) {
  Vec3 d = xa - xb;
  if (d.norm() == 0) return Vec3::Zero();
  return d / d.norm();
}

Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return springForceMagnitude(xa, xb, k, L0) * springDirection(xa, xb);
}

Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  Vec3 force(0, 0, -m * g);
  for (auto& s : springs) force += springForce(x, s.x, s.k, s.L0);
  return force;
}
