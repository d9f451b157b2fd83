// loses: all; misconception: zero
#include "triangle.h"

Mat9 massMatrix(const Vec3& m) {
  (void)m;
  return Mat9::Zero();
}

double triangleEnergy(const Vec9& x, const Vec3& k, const Vec3& L0) {
  (void)x, (void)k, (void)L0;
  return 0.0;
}

Vec9 triangleForce(const Vec9& x, const Vec3& k, const Vec3& L0) {
  (void)x, (void)k, (void)L0;
  return Vec9::Zero();
}
