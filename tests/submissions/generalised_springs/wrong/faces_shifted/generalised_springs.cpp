// loses: VolumeForce, MinusTheGradient, NoNetForce; misconception: faces_exchanged
// volumeForce gives the nodes 1, 2, 3 the cross products a x b, b x c, c x a, each the one of the node before: node 1
// should get b x c, the product of the two other edges.
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
  const Vec3 c = (x1 - x0).cross(x2 - x0);
  if (c.norm() == 0) return Vec9::Zero();
  const Vec3 n = c / c.norm();
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
  const Vec3 a = x.segment<3>(3) - x.segment<3>(0);
  const Vec3 b = x.segment<3>(6) - x.segment<3>(0);
  const Vec3 c = x.segment<3>(9) - x.segment<3>(0);
  Vec12 grad;
  grad.segment<3>(3) = a.cross(b) / 6;
  grad.segment<3>(6) = b.cross(c) / 6;
  grad.segment<3>(9) = c.cross(a) / 6;
  grad.segment<3>(0) = -(grad.segment<3>(3) + grad.segment<3>(6) + grad.segment<3>(9));
  return -kV * (tetrahedronVolume(x) - V0) * grad;
}
