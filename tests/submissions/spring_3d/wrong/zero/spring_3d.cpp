// loses: all; misconception: zero
#include "spring_3d.h"

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) {
  (void)xa, (void)xb, (void)k, (void)L0;
  return 0.0;
}

Vec3 springDirection(const Vec3& xa, const Vec3& xb) {
  (void)xa, (void)xb;
  return Vec3::Zero();
}

Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0) {
  (void)xa, (void)xb, (void)k, (void)L0;
  return Vec3::Zero();
}

Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  (void)x, (void)m, (void)springs, (void)g;
  return Vec3::Zero();
}
