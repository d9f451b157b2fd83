// loses: OneLine; misconception: energy_without_angle or missing_guard
#include "generalised_springs.h"

#include <Eigen/Geometry>

namespace {

Vec3 nodeOf(const Vec9& x, int i) { return x.segment<3>(3 * i); }
Vec3 cornerOf(const Vec12& x, int i) { return x.segment<3>(3 * i); }

double parabola(double k, double p, double p0) { return 0.5 * k * (p - p0) * (p - p0); }

}  // namespace

double bendingAngle(const Vec9& x) {
  Vec3 before = nodeOf(x, 1) - nodeOf(x, 0);
  Vec3 after = nodeOf(x, 2) - nodeOf(x, 1);
  return std::atan2(before.cross(after).norm(), before.dot(after));
}

double bendingEnergy(const Vec9& x, double theta0, double kb) { return parabola(kb, bendingAngle(x), theta0); }

Vec9 bendingForce(const Vec9& x, double theta0, double kb) {
  Vec3 before = nodeOf(x, 1) - nodeOf(x, 0);
  Vec3 after = nodeOf(x, 2) - nodeOf(x, 1);
  Vec3 axis = before.cross(after);
  Vec9 F = Vec9::Zero();
  double sine = axis.norm();
  if (sine == 0) return F;
  axis /= sine;
  double torque = -kb * (bendingAngle(x) - theta0);
  Vec3 onFirst = torque * axis.cross(before) / before.squaredNorm();
  Vec3 onLast = torque * axis.cross(after) / after.squaredNorm();
  F.segment<3>(0) = onFirst;
  F.segment<3>(3) = -onFirst - onLast;
  F.segment<3>(6) = onLast;
  return F;
}

double triangleArea(const Vec9& x) {
  Vec3 s = nodeOf(x, 1) - nodeOf(x, 0);
  Vec3 t = nodeOf(x, 2) - nodeOf(x, 0);
  return s.cross(t).norm() / 2;
}

double areaEnergy(const Vec9& x, double A0, double kA) { return parabola(kA, triangleArea(x), A0); }

Vec9 areaForce(const Vec9& x, double A0, double kA) {
  Vec9 F = Vec9::Zero();
  Vec3 normal = (nodeOf(x, 1) - nodeOf(x, 0)).cross(nodeOf(x, 2) - nodeOf(x, 0));
  double twice = normal.norm();
  if (twice == 0) return F;
  normal /= twice;
  double tension = -kA * (triangleArea(x) - A0);
  F.segment<3>(0) = tension * 0.5 * normal.cross(nodeOf(x, 2) - nodeOf(x, 1));
  F.segment<3>(3) = tension * 0.5 * normal.cross(nodeOf(x, 0) - nodeOf(x, 2));
  F.segment<3>(6) = tension * 0.5 * normal.cross(nodeOf(x, 1) - nodeOf(x, 0));
  return F;
}

double tetrahedronVolume(const Vec12& x) {
  Vec3 a = cornerOf(x, 1) - cornerOf(x, 0);
  Vec3 b = cornerOf(x, 2) - cornerOf(x, 0);
  Vec3 c = cornerOf(x, 3) - cornerOf(x, 0);
  return a.dot(b.cross(c)) / 6;
}

double volumeEnergy(const Vec12& x, double V0, double kV) { return parabola(kV, tetrahedronVolume(x), V0); }

Vec12 volumeForce(const Vec12& x, double V0, double kV) {
  Vec3 a = cornerOf(x, 1) - cornerOf(x, 0);
  Vec3 b = cornerOf(x, 2) - cornerOf(x, 0);
  Vec3 c = cornerOf(x, 3) - cornerOf(x, 0);
  double pressure = -kV * (tetrahedronVolume(x) - V0) / 6;
  Vec3 f1 = pressure * b.cross(c);
  Vec3 f2 = pressure * c.cross(a);
  Vec3 f3 = pressure * a.cross(b);
  Vec12 F;
  F << -(f1 + f2 + f3), f1, f2, f3;
  return F;
}
