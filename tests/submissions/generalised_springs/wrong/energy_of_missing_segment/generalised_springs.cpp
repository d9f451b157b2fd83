// loses: OneLine; misconception: energy_without_angle
// bendingEnergy forgets the case that two successive nodes coincide: it gives 1/2 kb theta0^2 there, where the energy
// is zero.
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
  const Vec3 x0 = x.head<3>(), x1 = x.segment<3>(3), x2 = x.tail<3>();
  return (x1 - x0).cross(x2 - x0).norm() / 2;
}

double areaEnergy(const Vec9& x, double A0, double kA) { return kA / 2 * std::pow(triangleArea(x) - A0, 2); }

Vec9 areaForce(const Vec9& x, double A0, double kA) {
  const Vec3 u = x.segment<3>(3) - x.segment<3>(0);
  const Vec3 v = x.segment<3>(6) - x.segment<3>(0);
  const Vec3 normal = u.cross(v);
  const double length = normal.norm();
  Vec9 F = Vec9::Zero();
  if (length == 0) return F;
  const Vec3 n = normal / length;
  const double s = kA * (triangleArea(x) - A0);
  F.segment<3>(3) = -s * 0.5 * v.cross(n);
  F.segment<3>(6) = -s * 0.5 * n.cross(u);
  F.segment<3>(0) = -(F.segment<3>(3) + F.segment<3>(6));
  return F;
}

double tetrahedronVolume(const Vec12& x) {
  const Vec3 x0 = x.head<3>();
  const Vec3 e1 = x.segment<3>(3) - x0, e2 = x.segment<3>(6) - x0, e3 = x.segment<3>(9) - x0;
  return 1.0 / 6.0 * e1.cross(e2).dot(e3);
}

double volumeEnergy(const Vec12& x, double V0, double kV) {
  const double V = tetrahedronVolume(x);
  return kV * (V - V0) * (V - V0) / 2;
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
