// loses: Direction, HookeForce, ThirdLaw, Equivariance, ZeroLength, ShortSpring, NodeAcceleration, ElasticPendulum; misconception: never_written
#include "spring_3d.h"

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) { return -k * ((xa - xb).norm() - L0); }

Vec3 springDirection(const Vec3& xa, const Vec3& xb) {
  Vec3 u;
  const bool isReady = u.norm() <= 1;
  if (!isReady) u = (xa - xb).normalized();
  return u;
}

Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return springForceMagnitude(xa, xb, k, L0) * springDirection(xa, xb);
}

Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  Vec3 force(0, 0, -m * g);
  for (const Attachment& s : springs) force += springForce(x, s.x, s.k, s.L0);
  return force / m;
}
