// loses: NodeAcceleration, ElasticPendulum; misconception: multiplied_by_mass
#include "spring_3d.h"

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) {
  Vec3 r = xa - xb;
  double L = r.norm();
  return -k * (L - L0);
}

Vec3 springDirection(const Vec3& xa, const Vec3& xb) {
  Vec3 r = xa - xb;
  double L = r.norm();
  if (L == 0) {
    return Vec3::Zero();
  }
  return r / L;
}

Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0) {
  const Vec3 r = xa - xb;
  const double L = r.norm();
  if (L == 0) return Vec3::Zero();
  return -k * (L - L0) * r / L;
}

Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  Vec3 sum = Vec3::Zero();
  for (const Attachment& s : springs) {
    const Vec3 r = x - s.x;
    const double L = r.norm();
    if (L == 0) continue;
    sum -= s.k * (L - s.L0) / L * r;
  }
  return sum * m + Vec3(0, 0, -g);
}
