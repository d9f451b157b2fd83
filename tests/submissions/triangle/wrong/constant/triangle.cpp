// loses: all; misconception: constant
#include "triangle.h"

Mat9 massMatrix(const Vec3&) { return 2.0 * Mat9::Identity(); }
double triangleEnergy(const Vec9&, const Vec3&, const Vec3&) { return 20.0; }
Vec9 triangleForce(const Vec9&, const Vec3&, const Vec3&) {
  return (Vec9() << 10, -3, 0, -4, 6, 1, -6, -3, -1).finished();
}
