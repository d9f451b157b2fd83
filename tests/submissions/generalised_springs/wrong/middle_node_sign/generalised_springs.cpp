// loses: BendingForce, MinusTheGradient, NoNetForce; misconception: none
// bendingForce has a wrong sign in the part of the middle node that comes from the first segment, so the forces do not
// add up to zero.
#include "generalised_springs.h"

#include <Eigen/Geometry>

double bendingAngle(const Vec9& x) {
  const Vec3 x0 = x.head<3>(), x1 = x.segment<3>(3), x2 = x.tail<3>();
  const Vec3 u = x1 - x0;
  const Vec3 w = x2 - x1;
  if (u.norm() == 0 || w.norm() == 0) return 0;  // not atan2(0, -0), which is pi
  const double s = u.cross(w).norm();
  const double c = u.dot(w);
  return std::atan2(s, c);
}

double bendingEnergy(const Vec9& x, double theta0, double kb) {
  const Vec3 x0 = x.head<3>(), x1 = x.segment<3>(3), x2 = x.tail<3>();
  if (x0 == x1 || x1 == x2) return 0;
  const double d = bendingAngle(x) - theta0;
  return kb * d * d / 2;
}

Vec9 bendingForce(const Vec9& x, double theta0, double kb) {
  const Vec3 x0 = x.head<3>(), x1 = x.segment<3>(3), x2 = x.tail<3>();
  const Vec3 u = x1 - x0;
  const Vec3 w = x2 - x1;
  Vec3 n = u.cross(w);
  const double size = n.norm();
  Vec9 F = Vec9::Zero();
  if (size == 0) return F;
  n /= size;
  const Vec3 gu = u.cross(n) / u.dot(u);
  const Vec3 gw = n.cross(w) / w.dot(w);
  const double torque = kb * (bendingAngle(x) - theta0);
  F.segment<3>(0) = torque * gu;
  F.segment<3>(3) = torque * (gw + gu);
  F.segment<3>(6) = -torque * gw;
  return F;
}

double triangleArea(const Vec9& x) {
  const Vec3 p = x.segment<3>(3) - x.segment<3>(0);
  const Vec3 q = x.segment<3>(6) - x.segment<3>(0);
  return p.cross(q).norm() / 2;
}

double areaEnergy(const Vec9& x, double A0, double kA) { return 0.5 * kA * std::pow(triangleArea(x) - A0, 2); }

Vec9 areaForce(const Vec9& x, double A0, double kA) {
  const Vec3 p = x.segment<3>(3) - x.segment<3>(0);
  const Vec3 q = x.segment<3>(6) - x.segment<3>(0);
  Vec3 n = p.cross(q);
  Vec9 F = Vec9::Zero();
  const double size = n.norm();
  if (size == 0) return F;
  n /= size;
  const Vec3 gp = 0.5 * q.cross(n);
  const Vec3 gq = 0.5 * n.cross(p);
  const double tension = kA * (triangleArea(x) - A0);
  F.segment<3>(0) = tension * (gp + gq);
  F.segment<3>(3) = -tension * gp;
  F.segment<3>(6) = -tension * gq;
  return F;
}

double tetrahedronVolume(const Vec12& x) {
  const Vec3 a = x.segment<3>(3) - x.segment<3>(0);
  const Vec3 b = x.segment<3>(6) - x.segment<3>(0);
  const Vec3 c = x.segment<3>(9) - x.segment<3>(0);
  return a.cross(b).dot(c) / 6;
}

double volumeEnergy(const Vec12& x, double V0, double kV) { return 0.5 * kV * std::pow(tetrahedronVolume(x) - V0, 2); }

Vec12 volumeForce(const Vec12& x, double V0, double kV) {
  const Vec3 a = x.segment<3>(3) - x.segment<3>(0);
  const Vec3 b = x.segment<3>(6) - x.segment<3>(0);
  const Vec3 c = x.segment<3>(9) - x.segment<3>(0);
  const double pressure = kV * (tetrahedronVolume(x) - V0) / 6;
  Vec12 F;
  F.segment<3>(3) = -pressure * b.cross(c);
  F.segment<3>(6) = -pressure * c.cross(a);
  F.segment<3>(9) = -pressure * a.cross(b);
  F.segment<3>(0) = -(F.segment<3>(3) + F.segment<3>(6) + F.segment<3>(9));
  return F;
}
