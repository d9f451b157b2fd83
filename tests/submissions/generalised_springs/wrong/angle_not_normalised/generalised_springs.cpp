// loses: BendingAngle, BendingEnergy, BendingForce, MinusTheGradient, Narrow; misconception: not_normalised
#include "generalised_springs.h"

#include <Eigen/Geometry>

namespace {

Vec3 node(const Vec9& x, int i) { return x.segment<3>(3 * i); }
Vec3 node(const Vec12& x, int i) { return x.segment<3>(3 * i); }

}  // namespace

double bendingAngle(const Vec9& x) {
  const Vec3 u = node(x, 1) - node(x, 0);
  const Vec3 w = node(x, 2) - node(x, 1);
  return std::acos(std::clamp(u.dot(w), -1.0, 1.0));
}

double bendingEnergy(const Vec9& x, double theta0, double kb) {
  if (node(x, 1) == node(x, 0) || node(x, 2) == node(x, 1)) return 0.0;
  const double d = bendingAngle(x) - theta0;
  return 0.5 * kb * d * d;
}

Vec9 bendingForce(const Vec9& x, double theta0, double kb) {
  const Vec3 u = node(x, 1) - node(x, 0);
  const Vec3 w = node(x, 2) - node(x, 1);
  Vec3 n = u.cross(w);
  const double s = n.norm();
  Vec9 F = Vec9::Zero();
  if (s == 0) return F;
  n /= s;
  const double torque = -kb * (bendingAngle(x) - theta0);
  const Vec3 first = torque * n.cross(u) / u.squaredNorm();
  const Vec3 last = torque * n.cross(w) / w.squaredNorm();
  F << first, -first - last, last;
  return F;
}

double triangleArea(const Vec9& x) {
  return 0.5 * (node(x, 1) - node(x, 0)).cross(node(x, 2) - node(x, 0)).norm();
}

double areaEnergy(const Vec9& x, double A0, double kA) {
  const double d = triangleArea(x) - A0;
  return 0.5 * kA * d * d;
}

Vec9 areaForce(const Vec9& x, double A0, double kA) {
  Vec3 n = (node(x, 1) - node(x, 0)).cross(node(x, 2) - node(x, 0));
  const double s = n.norm();
  Vec9 F = Vec9::Zero();
  if (s == 0) return F;
  n /= s;
  const double pressure = -kA * (triangleArea(x) - A0);
  for (int i = 0; i < 3; ++i) {
    F.segment<3>(3 * i) = pressure * 0.5 * n.cross(node(x, (i + 2) % 3) - node(x, (i + 1) % 3));
  }
  return F;
}

double tetrahedronVolume(const Vec12& x) {
  const Vec3 a = node(x, 1) - node(x, 0), b = node(x, 2) - node(x, 0), c = node(x, 3) - node(x, 0);
  return a.dot(b.cross(c)) / 6;
}

double volumeEnergy(const Vec12& x, double V0, double kV) {
  const double d = tetrahedronVolume(x) - V0;
  return 0.5 * kV * d * d;
}

Vec12 volumeForce(const Vec12& x, double V0, double kV) {
  const Vec3 a = node(x, 1) - node(x, 0), b = node(x, 2) - node(x, 0), c = node(x, 3) - node(x, 0);
  const double pressure = -kV * (tetrahedronVolume(x) - V0) / 6;
  const Vec3 f1 = pressure * b.cross(c), f2 = pressure * c.cross(a), f3 = pressure * a.cross(b);
  Vec12 F;
  F << -f1 - f2 - f3, f1, f2, f3;
  return F;
}
