#include "spring_3d.h"

// Written component by component instead of the lecture's vectors.

namespace oracle {

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return k * L0 - k * std::hypot(xa[0] - xb[0], xa[1] - xb[1], xa[2] - xb[2]);
}

Vec3 springDirection(const Vec3& xa, const Vec3& xb) {
  const double L = std::hypot(xb[0] - xa[0], xb[1] - xa[1], xb[2] - xa[2]);
  Vec3 direction = Vec3::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    if (L > 0) direction[axis] = (xa[axis] - xb[axis]) / L;
  }
  return direction;
}

Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return given::springForceMagnitude(xa, xb, k, L0) * given::springDirection(xa, xb);
}

Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  Vec3 acceleration(0, 0, -g);
  for (const Attachment& spring : springs) acceleration += given::springForce(x, spring.x, spring.k, spring.L0) / m;
  return acceleration;
}

}  // namespace oracle
