#include "spring_3d.h"

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return k * (L0 - (xa - xb).norm());
}

Vec3 springDirection(const Vec3& xa, const Vec3& xb) {
  const Vec3 r = xa - xb;
  const double len = r.norm();
  return len == 0.0 ? Vec3(Vec3::Zero()) : Vec3(r / len);
}

Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0) {
  const double f = springForceMagnitude(xa, xb, k, L0);
  return f * springDirection(xa, xb);
}

Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < springs.size(); i++) {
    sum += springForce(x, springs[i].x, springs[i].k, springs[i].L0);
  }
  return sum / m + Vec3(0, 0, -g);
}
