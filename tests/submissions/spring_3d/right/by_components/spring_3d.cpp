#include "spring_3d.h"

// No vector algebra: every component by hand, and the force written out.

namespace {

double lengthOf(const Vec3& xa, const Vec3& xb) {
  double sum = 0;
  for (int i = 0; i < 3; i++) sum += (xa(i) - xb(i)) * (xa(i) - xb(i));
  return sqrt(sum);
}

}  // namespace

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) { return k * (L0 - lengthOf(xa, xb)); }

Vec3 springDirection(const Vec3& xa, const Vec3& xb) {
  Vec3 direction;
  double L = lengthOf(xa, xb);
  for (int i = 0; i < 3; i++) direction(i) = L > 0 ? (xa(i) - xb(i)) / L : 0.0;
  return direction;
}

Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0) {
  double L = lengthOf(xa, xb);
  if (L == 0) return Vec3(0, 0, 0);
  double factor = k * (L0 / L - 1);
  return Vec3(factor * (xa(0) - xb(0)), factor * (xa(1) - xb(1)), factor * (xa(2) - xb(2)));
}

Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  Vec3 a(0, 0, -g);
  for (unsigned i = 0; i < springs.size(); i++) {
    Vec3 F = springForce(x, springs[i].x, springs[i].k, springs[i].L0);
    a += F / m;
  }
  return a;
}
