#include "generalised_springs.h"

#include <Eigen/Geometry>

double bendingAngle(const Vec9& x) {
  const Vec3 u = x.segment<3>(3) - x.segment<3>(0);
  const Vec3 w = x.segment<3>(6) - x.segment<3>(3);
  return std::atan2(u.cross(w).norm(), u.dot(w));
}

double bendingEnergy(const Vec9& x, double theta0, double kb) {
  const Vec3 u = x.segment<3>(3) - x.segment<3>(0);
  const Vec3 w = x.segment<3>(6) - x.segment<3>(3);
  if (u.norm() == 0 || w.norm() == 0) return 0.0;
  const double bent = bendingAngle(x) - theta0;
  return 0.5 * kb * bent * bent;
}

Vec9 bendingForce(const Vec9& x, double theta0, double kb) {
  const Vec3 u = x.segment<3>(3) - x.segment<3>(0);
  const Vec3 w = x.segment<3>(6) - x.segment<3>(3);
  const Vec3 normal = u.cross(w);
  if (normal.norm() == 0) return Vec9::Zero();
  // The angle grows when w turns about the normal, and when u turns the other way.
  const Vec3 n = normal / normal.norm();
  const Vec3 byU = -n.cross(u) / u.squaredNorm();
  const Vec3 byW = n.cross(w) / w.squaredNorm();
  Vec9 gradient;
  gradient << -byU, byU - byW, byW;
  return -kb * (bendingAngle(x) - theta0) * gradient;
}

double triangleArea(const Vec9& x) {
  const Vec3 u = x.segment<3>(3) - x.segment<3>(0);
  const Vec3 w = x.segment<3>(6) - x.segment<3>(0);
  return 0.5 * u.cross(w).norm();
}

double areaEnergy(const Vec9& x, double A0, double kA) {
  const double more = triangleArea(x) - A0;
  return 0.5 * kA * more * more;
}

Vec9 areaForce(const Vec9& x, double A0, double kA) {
  const Vec3 u = x.segment<3>(3) - x.segment<3>(0);
  const Vec3 w = x.segment<3>(6) - x.segment<3>(0);
  const Vec3 normal = u.cross(w);
  if (normal.norm() == 0) return Vec9::Zero();
  const Vec3 n = normal / normal.norm();
  Vec9 F;
  for (int i = 0; i < 3; ++i) {
    const Vec3 opposite = x.segment<3>(3 * ((i + 2) % 3)) - x.segment<3>(3 * ((i + 1) % 3));
    F.segment<3>(3 * i) = -kA * (triangleArea(x) - A0) * 0.5 * n.cross(opposite);
  }
  return F;
}

double tetrahedronVolume(const Vec12& x) {
  const Vec3 a = x.segment<3>(3) - x.segment<3>(0);
  const Vec3 b = x.segment<3>(6) - x.segment<3>(0);
  const Vec3 c = x.segment<3>(9) - x.segment<3>(0);
  return a.dot(b.cross(c)) / 6.0;
}

double volumeEnergy(const Vec12& x, double V0, double kV) {
  const double more = tetrahedronVolume(x) - V0;
  return 0.5 * kV * more * more;
}

Vec12 volumeForce(const Vec12& x, double V0, double kV) {
  const Vec3 a = x.segment<3>(3) - x.segment<3>(0);
  const Vec3 b = x.segment<3>(6) - x.segment<3>(0);
  const Vec3 c = x.segment<3>(9) - x.segment<3>(0);
  const Vec3 byA = b.cross(c) / 6.0;
  const Vec3 byB = c.cross(a) / 6.0;
  const Vec3 byC = a.cross(b) / 6.0;
  Vec12 gradient;
  gradient << -byA - byB - byC, byA, byB, byC;
  return -kV * (tetrahedronVolume(x) - V0) * gradient;
}
