// loses: NodeAcceleration, ElasticPendulum; misconception: last_spring_only
#include "spring_3d.h"

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) { return -k * ((xa - xb).norm() - L0); }

Vec3 springDirection(const Vec3& xa, const Vec3& xb) {
  const Vec3 difference = xa - xb;
  const double L = difference.norm();
  return L == 0 ? Vec3(Vec3::Zero()) : Vec3(difference / L);
}

Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return springForceMagnitude(xa, xb, k, L0) * springDirection(xa, xb);
}

Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  const Vec3 weight(0, 0, -m * g);
  Vec3 elastic = Vec3::Zero();
  for (const Attachment& spring : springs) {
    elastic = springForce(x, spring.x, spring.k, spring.L0);
  }
  return (elastic + weight) / m;
}
