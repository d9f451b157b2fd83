// loses: VolumeForce, MinusTheGradient, NoNetForce; misconception: integer_division
#include "generalised_springs.h"

#include <Eigen/Geometry>

// A = |N| / 2 with N = u x w, so the derivative of A with respect to u is (w x N) / (2 |N|), and so on.

double bendingAngle(const Vec9& x) {
  const Vec3 x0 = x.segment<3>(0), x1 = x.segment<3>(3), x2 = x.segment<3>(6);
  const double sine = (x1 - x0).cross(x2 - x1).norm(), cosine = (x1 - x0).dot(x2 - x1);
  if (sine == 0 && cosine == 0) return 0;
  return std::atan2(sine, cosine);
}

double bendingEnergy(const Vec9& x, double theta0, double kb) {
  const Vec3 x0 = x.segment<3>(0), x1 = x.segment<3>(3), x2 = x.segment<3>(6);
  double E = 0;
  if (x0 != x1 && x1 != x2) E = 0.5 * kb * (theta0 - bendingAngle(x)) * (theta0 - bendingAngle(x));
  return E;
}

Vec9 bendingForce(const Vec9& x, double theta0, double kb) {
  const Vec3 x0 = x.segment<3>(0), x1 = x.segment<3>(3), x2 = x.segment<3>(6);
  const Vec3 u = x1 - x0, w = x2 - x1, N = u.cross(w);
  Vec3 f0 = Vec3::Zero(), f2 = Vec3::Zero();
  if (N.squaredNorm() > 0) {
    const double s = kb * (theta0 - bendingAngle(x)) / N.norm();
    f0 = N.cross(u) * (s / u.squaredNorm());
    f2 = N.cross(w) * (s / w.squaredNorm());
  }
  Vec9 F;
  F << f0, -(f0 + f2), f2;
  return F;
}

double triangleArea(const Vec9& x) {
  const Vec3 x0 = x.segment<3>(0), x1 = x.segment<3>(3), x2 = x.segment<3>(6);
  return (x2 - x0).cross(x1 - x0).norm() * 0.5;
}

double areaEnergy(const Vec9& x, double A0, double kA) {
  const double A = triangleArea(x);
  return 0.5 * kA * (A - A0) * (A - A0);
}

Vec9 areaForce(const Vec9& x, double A0, double kA) {
  const Vec3 x0 = x.segment<3>(0), x1 = x.segment<3>(3), x2 = x.segment<3>(6);
  const Vec3 u = x1 - x0, w = x2 - x0, N = u.cross(w);
  Vec9 F = Vec9::Zero();
  if (N.squaredNorm() > 0) {
    const Vec3 f1 = kA * (A0 - triangleArea(x)) * w.cross(N) / (2 * N.norm());
    const Vec3 f2 = kA * (A0 - triangleArea(x)) * N.cross(u) / (2 * N.norm());
    F << -f1 - f2, f1, f2;
  }
  return F;
}

double tetrahedronVolume(const Vec12& x) {
  const Vec3 a = x.segment<3>(3) - x.segment<3>(0), b = x.segment<3>(6) - x.segment<3>(0),
             c = x.segment<3>(9) - x.segment<3>(0);
  return (1.0 / 6.0) * b.dot(c.cross(a));
}

double volumeEnergy(const Vec12& x, double V0, double kV) {
  const double V = tetrahedronVolume(x);
  return 0.5 * kV * (V - V0) * (V - V0);
}

Vec12 volumeForce(const Vec12& x, double V0, double kV) {
  const Vec3 a = x.segment<3>(3) - x.segment<3>(0), b = x.segment<3>(6) - x.segment<3>(0),
             c = x.segment<3>(9) - x.segment<3>(0);
  const double p = kV * (V0 - tetrahedronVolume(x));
  Vec12 F;
  F.segment<3>(3) = p * b.cross(c) * (1 / 6);
  F.segment<3>(6) = p * c.cross(a) * (1 / 6);
  F.segment<3>(9) = p * a.cross(b) * (1 / 6);
  F.segment<3>(0) = -F.segment<3>(3) - F.segment<3>(6) - F.segment<3>(9);
  return F;
}
