// loses: Narrow; misconception: threshold
// areaForce takes every triangle whose cross product is shorter than 1e-10 for three nodes on one line, and gives it
// no force.
#include "generalised_springs.h"

#include <Eigen/Geometry>  // for u.cross(w)

double bendingAngle(const Vec9& x) {
  const Vec3 x0 = x.head<3>(), x1 = x.segment<3>(3), x2 = x.tail<3>();
  const Vec3 u = x1 - x0, w = x2 - x1;
  const double sine = u.cross(w).norm();
  const double cosine = u.dot(w);
  return std::atan2(sine, cosine);
}

double bendingEnergy(const Vec9& x, double theta0, double kb) {
  const Vec3 u = x.segment<3>(3) - x.segment<3>(0);
  const Vec3 w = x.segment<3>(6) - x.segment<3>(3);
  if (u.isZero(0) || w.isZero(0)) return 0.0;
  const double d = bendingAngle(x) - theta0;
  return 0.5 * kb * d * d;
}

Vec9 bendingForce(const Vec9& x, double theta0, double kb) {
  Vec9 F = Vec9::Zero();
  const Vec3 u = x.segment<3>(3) - x.segment<3>(0);
  const Vec3 w = x.segment<3>(6) - x.segment<3>(3);
  const Vec3 normal = u.cross(w);
  const double length = normal.norm();
  if (length > 0) {
    const Vec3 n = normal / length;
    const double torque = kb * (bendingAngle(x) - theta0);
    F.segment<3>(0) = -torque * n.cross(u) / u.dot(u);
    F.segment<3>(6) = -torque * n.cross(w) / w.dot(w);
    F.segment<3>(3) = -F.segment<3>(0) - F.segment<3>(6);
  }
  return F;
}

double triangleArea(const Vec9& x) {
  const Vec3 u = x.segment<3>(3) - x.segment<3>(0);
  const Vec3 v = x.segment<3>(6) - x.segment<3>(0);
  return 0.5 * u.cross(v).norm();
}

double areaEnergy(const Vec9& x, double A0, double kA) { return kA / 2 * std::pow(triangleArea(x) - A0, 2); }

Vec9 areaForce(const Vec9& x, double A0, double kA) {
  const Vec3 x0 = x.segment<3>(0), x1 = x.segment<3>(3), x2 = x.segment<3>(6);
  Vec3 n = (x1 - x0).cross(x2 - x0);
  const double length = n.norm();
  if (length < 1e-10) return Vec9::Zero();  // degenerate
  n /= length;
  Vec9 gradient;
  gradient << 0.5 * n.cross(x2 - x1), 0.5 * n.cross(x0 - x2), 0.5 * n.cross(x1 - x0);
  return -kA * (triangleArea(x) - A0) * gradient;
}

double tetrahedronVolume(const Vec12& x) {
  const Vec3 x0 = x.head<3>();
  const Vec3 e1 = x.segment<3>(3) - x0, e2 = x.segment<3>(6) - x0, e3 = x.segment<3>(9) - x0;
  return 1.0 / 6.0 * e1.cross(e2).dot(e3);
}

double volumeEnergy(const Vec12& x, double V0, double kV) {
  const double d = tetrahedronVolume(x) - V0;
  return 0.5 * kV * d * d;
}

Vec12 volumeForce(const Vec12& x, double V0, double kV) {
  const Vec3 x0 = x.head<3>();
  const Vec3 e1 = x.segment<3>(3) - x0, e2 = x.segment<3>(6) - x0, e3 = x.segment<3>(9) - x0;
  const double s = -kV * (tetrahedronVolume(x) - V0) / 6.0;
  Vec12 F;
  F.segment<3>(3) = s * e2.cross(e3);
  F.segment<3>(6) = s * e3.cross(e1);
  F.segment<3>(9) = s * e1.cross(e2);
  F.segment<3>(0) = -F.segment<3>(3) - F.segment<3>(6) - F.segment<3>(9);
  return F;
}
