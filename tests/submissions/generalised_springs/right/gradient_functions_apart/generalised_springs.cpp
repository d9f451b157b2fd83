#include "generalised_springs.h"

#include <Eigen/Geometry>

// Each number has its gradient; energy and force are then always the same line.

static Vec9 gradientOfAngle(const Vec9& x) {
  const Vec3 u = x.segment<3>(3) - x.head<3>();
  const Vec3 w = x.tail<3>() - x.segment<3>(3);
  const Vec3 c = u.cross(w);
  if (c.isZero(0)) return Vec9::Zero();
  const Vec3 n = c.normalized();
  const Vec3 gu = u.cross(n) / u.dot(u);
  const Vec3 gw = n.cross(w) / w.dot(w);
  Vec9 g;
  g << -gu, gu - gw, gw;
  return g;
}

static Vec9 gradientOfArea(const Vec9& x) {
  const Vec3 u = x.segment<3>(3) - x.head<3>();
  const Vec3 w = x.tail<3>() - x.head<3>();
  const Vec3 c = u.cross(w);
  if (c.isZero(0)) return Vec9::Zero();
  const Vec3 n = c.normalized();
  const Vec3 g1 = w.cross(n) / 2, g2 = n.cross(u) / 2;
  Vec9 g;
  g << -g1 - g2, g1, g2;
  return g;
}

static Vec12 gradientOfVolume(const Vec12& x) {
  const Vec3 x0 = x.segment<3>(0), x1 = x.segment<3>(3), x2 = x.segment<3>(6), x3 = x.segment<3>(9);
  Vec12 g;
  g << -(x2 - x1).cross(x3 - x1), (x2 - x0).cross(x3 - x0), (x3 - x0).cross(x1 - x0), (x1 - x0).cross(x2 - x0);
  return g / 6;
}

double bendingAngle(const Vec9& x) {
  const Vec3 u = x.segment<3>(3) - x.head<3>();
  const Vec3 w = x.tail<3>() - x.segment<3>(3);
  return std::atan2(u.cross(w).norm(), u.dot(w));
}

double bendingEnergy(const Vec9& x, double theta0, double kb) {
  const Vec3 u = x.segment<3>(3) - x.head<3>();
  const Vec3 w = x.tail<3>() - x.segment<3>(3);
  if (u.isZero(0) || w.isZero(0)) return 0;
  return 0.5 * kb * std::pow(bendingAngle(x) - theta0, 2);
}

Vec9 bendingForce(const Vec9& x, double theta0, double kb) {
  return -kb * (bendingAngle(x) - theta0) * gradientOfAngle(x);
}

double triangleArea(const Vec9& x) {
  const Vec3 u = x.segment<3>(3) - x.head<3>();
  const Vec3 w = x.tail<3>() - x.head<3>();
  return 0.5 * u.cross(w).norm();
}

double areaEnergy(const Vec9& x, double A0, double kA) { return 0.5 * kA * std::pow(triangleArea(x) - A0, 2); }

Vec9 areaForce(const Vec9& x, double A0, double kA) { return -kA * (triangleArea(x) - A0) * gradientOfArea(x); }

double tetrahedronVolume(const Vec12& x) {
  const Vec3 x0 = x.segment<3>(0), x1 = x.segment<3>(3), x2 = x.segment<3>(6), x3 = x.segment<3>(9);
  return (x1 - x0).cross(x2 - x0).dot(x3 - x0) / 6;
}

double volumeEnergy(const Vec12& x, double V0, double kV) { return 0.5 * kV * std::pow(tetrahedronVolume(x) - V0, 2); }

Vec12 volumeForce(const Vec12& x, double V0, double kV) {
  return -kV * (tetrahedronVolume(x) - V0) * gradientOfVolume(x);
}
