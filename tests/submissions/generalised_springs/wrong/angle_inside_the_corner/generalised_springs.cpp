// loses: BendingAngle; misconception: interior_angle
// bendingAngle measures the inner angle of the corner at x1, which is pi for a straight line, instead of the angle by
// which the line bends.
#include "generalised_springs.h"

#include <Eigen/Geometry>

static Vec3 node(const Vec9& x, int i) { return x.segment<3>(3 * (i % 3)); }
static Vec3 node(const Vec12& x, int i) { return x.segment<3>(3 * i); }

double bendingAngle(const Vec9& x) {
  const Vec3 before = node(x, 0) - node(x, 1);
  const Vec3 after = node(x, 2) - node(x, 1);
  if (before.norm() == 0 || after.norm() == 0) return 0.0;
  return std::atan2(before.cross(after).norm(), before.dot(after));
}

double bendingEnergy(const Vec9& x, double theta0, double kb) {
  const double lu = (node(x, 1) - node(x, 0)).norm();
  const double lw = (node(x, 2) - node(x, 1)).norm();
  if (lu == 0 || lw == 0) return 0.0;
  const double diff = bendingAngle(x) - theta0;
  return 0.5 * kb * diff * diff;
}

Vec9 bendingForce(const Vec9& x, double theta0, double kb) {
  const Vec3 before = node(x, 1) - node(x, 0);
  const Vec3 after = node(x, 2) - node(x, 1);
  const Vec3 normal = before.cross(after);
  if (normal.squaredNorm() == 0) return Vec9::Zero();
  const Vec3 n = normal.normalized();
  const double l1 = before.norm(), l2 = after.norm();
  // The outer nodes move at right angles to their segments, the middle one balances them.
  const Vec3 grad0 = n.cross(before / l1) / l1;
  const Vec3 grad2 = n.cross(after / l2) / l2;
  const Vec3 grad1 = -grad0 - grad2;
  Vec9 grad;
  grad << grad0, grad1, grad2;
  return -kb * (bendingAngle(x) - theta0) * grad;
}

double triangleArea(const Vec9& x) {
  const Vec3 toFirst = node(x, 0) - node(x, 1);
  const Vec3 toLast = node(x, 2) - node(x, 1);
  return 0.5 * toFirst.cross(toLast).norm();
}

double areaEnergy(const Vec9& x, double A0, double kA) {
  const double diff = triangleArea(x) - A0;
  return 0.5 * kA * diff * diff;
}

Vec9 areaForce(const Vec9& x, double A0, double kA) {
  const Vec3 normal = (node(x, 1) - node(x, 0)).cross(node(x, 2) - node(x, 1));
  Vec9 F = Vec9::Zero();
  if (normal.norm() == 0) return F;
  const Vec3 n = normal.normalized();
  const double diff = triangleArea(x) - A0;
  for (int i = 0; i < 3; i++) {
    const Vec3 side = node(x, i + 2) - node(x, i + 1);
    const Vec3 grad = 0.5 * n.cross(side);
    F.segment<3>(3 * i) = -kA * diff * grad;
  }
  return F;
}

double tetrahedronVolume(const Vec12& x) {
  const Vec3 base = (node(x, 1) - node(x, 0)).cross(node(x, 2) - node(x, 0)) / 2;  // area times normal
  return base.dot(node(x, 3) - node(x, 0)) / 3;
}

double volumeEnergy(const Vec12& x, double V0, double kV) {
  const double diff = tetrahedronVolume(x) - V0;
  return 0.5 * kV * diff * diff;
}

Vec12 volumeForce(const Vec12& x, double V0, double kV) {
  static const int faces[4][3] = {{1, 3, 2}, {0, 2, 3}, {0, 3, 1}, {0, 1, 2}};
  const double diff = tetrahedronVolume(x) - V0;
  Vec12 F;
  for (int i = 0; i < 4; i++) {
    const Vec3 p = node(x, faces[i][0]), q = node(x, faces[i][1]), r = node(x, faces[i][2]);
    F.segment<3>(3 * i) = -kV * diff * (q - p).cross(r - p) / 6;
  }
  return F;
}
