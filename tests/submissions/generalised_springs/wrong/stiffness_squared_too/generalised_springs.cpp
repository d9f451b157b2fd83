// loses: VolumeEnergy, MinusTheGradient; misconception: squared
// volumeEnergy squares the stiffness together with the distance from V0.
#include "generalised_springs.h"

#include <Eigen/Geometry>  // for u.cross(w)

double bendingAngle(const Vec9& x) {
  const Vec3 u = x.segment<3>(3) - x.segment<3>(0);
  const Vec3 w = x.segment<3>(6) - x.segment<3>(3);
  return std::atan2(u.cross(w).norm(), u.dot(w));
}

double bendingEnergy(const Vec9& x, double theta0, double kb) {
  const Vec3 u = x.segment<3>(3) - x.segment<3>(0);
  const Vec3 w = x.segment<3>(6) - x.segment<3>(3);
  if (u.isZero(0) || w.isZero(0)) return 0.0;
  const double d = bendingAngle(x) - theta0;
  return 0.5 * kb * d * d;
}

Vec9 bendingForce(const Vec9& x, double theta0, double kb) {
  const Vec3 u = x.segment<3>(3) - x.segment<3>(0);
  const Vec3 w = x.segment<3>(6) - x.segment<3>(3);
  const Vec3 c = u.cross(w);
  if (c.norm() == 0) return Vec9::Zero();
  const Vec3 n = c / c.norm();
  const Vec3 gradU = -n.cross(u) / u.squaredNorm();
  const Vec3 gradW = n.cross(w) / w.squaredNorm();
  Vec9 gradient;
  gradient << -gradU, gradU - gradW, gradW;
  return -kb * (bendingAngle(x) - theta0) * gradient;
}

double triangleArea(const Vec9& x) {
  const Vec3 u = x.segment<3>(3) - x.segment<3>(0);
  const Vec3 v = x.segment<3>(6) - x.segment<3>(0);
  return 0.5 * u.cross(v).norm();
}

double areaEnergy(const Vec9& x, double A0, double kA) {
  const double d = triangleArea(x) - A0;
  return 0.5 * kA * d * d;
}

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
  const Vec3 a = x.segment<3>(3) - x.segment<3>(0);
  const Vec3 b = x.segment<3>(6) - x.segment<3>(0);
  const Vec3 c = x.segment<3>(9) - x.segment<3>(0);
  return a.dot(b.cross(c)) / 6;
}

double volumeEnergy(const Vec12& x, double V0, double kV) {
  return std::pow(kV * (tetrahedronVolume(x) - V0), 2) / 2;
}

Vec12 volumeForce(const Vec12& x, double V0, double kV) {
  const Vec3 a = x.segment<3>(3) - x.segment<3>(0);
  const Vec3 b = x.segment<3>(6) - x.segment<3>(0);
  const Vec3 c = x.segment<3>(9) - x.segment<3>(0);
  const Vec3 ga = b.cross(c) / 6, gb = c.cross(a) / 6, gc = a.cross(b) / 6;
  Vec12 gradient;
  gradient << -(ga + gb + gc), ga, gb, gc;
  return -kV * (tetrahedronVolume(x) - V0) * gradient;
}
