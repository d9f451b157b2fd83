// loses: ShortSpring; misconception: threshold
// thought: smaller than any atom
#include "spring_3d.h"

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) {
  Vec3 r = xa - xb;
  double L = r.norm();
  return -k * (L - L0);
}

Vec3 springDirection(const Vec3& xa, const Vec3& xb) {
  constexpr double tiny = 1e-60;
  const Vec3 r = xa - xb;
  const double L = r.norm();
  return L > tiny ? Vec3(r / L) : Vec3(0, 0, 0);
}

Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0) {
  double mag = springForceMagnitude(xa, xb, k, L0);
  Vec3 dir = springDirection(xa, xb);
  return mag * dir;
}

Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  Vec3 F(0, 0, -m * g);
  for (const Attachment& s : springs) {
    F += springForce(x, s.x, s.k, s.L0);
  }
  return F / m;
}
