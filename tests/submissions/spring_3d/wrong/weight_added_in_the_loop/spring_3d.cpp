// loses: NodeAcceleration, ElasticPendulum; misconception: gravity_per_spring
#include "spring_3d.h"

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) {
  double length = sqrt((xa - xb).squaredNorm());
  return k * (L0 - length);
}

Vec3 springDirection(const Vec3& xa, const Vec3& xb) {
  double length = sqrt((xa - xb).squaredNorm());
  if (length != 0) return (xa - xb) / length;
  return Vec3(0, 0, 0);
}

Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0) {
  double magnitude = springForceMagnitude(xa, xb, k, L0);
  return magnitude * springDirection(xa, xb);
}

Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  Vec3 sum(0, 0, 0);
  for (const Attachment& s : springs) {
    sum += springForce(x, s.x, s.k, s.L0);
    sum += m * Vec3(0, 0, -g);
  }
  return sum / m;
}
