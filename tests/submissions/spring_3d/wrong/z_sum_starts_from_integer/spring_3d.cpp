// loses: NodeAcceleration, ElasticPendulum; misconception: whole_numbers or integer_division
// thought: accumulate with 0
#include "spring_3d.h"

#include <numeric>

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return k * (L0 - (xa - xb).norm());
}

Vec3 springDirection(const Vec3& xa, const Vec3& xb) {
  const auto n = (xa - xb).norm();
  return n > 0.0 ? Vec3((xa - xb) / n) : Vec3(Vec3::Zero());
}

Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return springDirection(xa, xb) * springForceMagnitude(xa, xb, k, L0);
}

Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  Vec3 a(0, 0, -g);
  for (int i = 0; i < 3; ++i) {
    a[i] += std::accumulate(springs.begin(), springs.end(), 0, [&](auto sum, const Attachment& s) {
      return sum + springForce(x, s.x, s.k, s.L0)[i];
    }) / m;
  }
  return a;
}
