// loses: NodeAcceleration, ElasticPendulum, ZeroLength, ShortSpring; misconception: stateful
#include "spring_3d.h"

static Vec3 total = Vec3::Zero();  // sum of the forces

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) { return -k * ((xa - xb).norm() - L0); }

Vec3 springDirection(const Vec3& xa, const Vec3& xb) {
  if (xa == xb) return Vec3::Zero();
  return (xa - xb) / (xa - xb).norm();
}

Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return springForceMagnitude(xa, xb, k, L0) * springDirection(xa, xb);
}

Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  for (const Attachment& s : springs) total += springForce(x, s.x, s.k, s.L0);
  return total / m - Vec3(0, 0, g);
}
