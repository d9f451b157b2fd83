#include "generalised_springs.h"

#include <Eigen/Geometry>

// The force by the components at right angles: what is left of w without its part along u, and the other way round.
namespace {

Vec3 part(const Vec9& x, int i) { return x.segment<3>(3 * i); }

}  // namespace

double bendingAngle(const Vec9& x) {
  const Vec3 u = part(x, 1) - part(x, 0), w = part(x, 2) - part(x, 1);
  return std::atan2(u.cross(w).stableNorm(), u.dot(w));
}

double bendingEnergy(const Vec9& x, double theta0, double kb) {
  const double lengths = (part(x, 1) - part(x, 0)).norm() * (part(x, 2) - part(x, 1)).norm();
  if (lengths == 0) return 0;
  return 0.5 * kb * (bendingAngle(x) - theta0) * (bendingAngle(x) - theta0);
}

Vec9 bendingForce(const Vec9& x, double theta0, double kb) {
  const Vec3 u = part(x, 1) - part(x, 0), w = part(x, 2) - part(x, 1);
  const Vec3 n = u.cross(w);
  Vec9 g = Vec9::Zero();
  if (n.norm() > 0) {
    const Vec3 across = n.cross(u).normalized();  // in the plane, at right angles to u, on the side of w
    const Vec3 acrossW = n.cross(w).normalized();
    g.head<3>() = across / u.norm();
    g.tail<3>() = acrossW / w.norm();
    g.segment<3>(3) = -g.head<3>() - g.tail<3>();
  }
  return (-kb * (bendingAngle(x) - theta0)) * g;
}

double triangleArea(const Vec9& x) { return 0.5 * (part(x, 0) - part(x, 1)).cross(part(x, 2) - part(x, 1)).norm(); }

double areaEnergy(const Vec9& x, double A0, double kA) {
  return 0.5 * kA * (triangleArea(x) - A0) * (triangleArea(x) - A0);
}

Vec9 areaForce(const Vec9& x, double A0, double kA) {
  const Vec3 n = (part(x, 0) - part(x, 2)).cross(part(x, 1) - part(x, 2));
  Vec9 g = Vec9::Zero();
  for (int i = 0; n.norm() > 0 && i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    g.segment<3>(3 * i) = n.cross(part(x, k) - part(x, j)) / n.norm() / 2;
  }
  return (-kA * (triangleArea(x) - A0)) * g;
}

double tetrahedronVolume(const Vec12& x) {
  const Vec3 a = x.segment<3>(3) - x.segment<3>(0), b = x.segment<3>(6) - x.segment<3>(0),
             c = x.segment<3>(9) - x.segment<3>(0);
  return (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6;
}

double volumeEnergy(const Vec12& x, double V0, double kV) {
  return 0.5 * kV * (tetrahedronVolume(x) - V0) * (tetrahedronVolume(x) - V0);
}

Vec12 volumeForce(const Vec12& x, double V0, double kV) {
  const auto at = [&x](int i) { return Vec3(x.segment<3>(3 * i)); };
  const double p = -kV * (tetrahedronVolume(x) - V0) / 6;
  Vec12 F;
  F << p * (at(3) - at(1)).cross(at(2) - at(1)), p * (at(2) - at(0)).cross(at(3) - at(0)),
      p * (at(3) - at(0)).cross(at(1) - at(0)), p * (at(1) - at(0)).cross(at(2) - at(0));
  return F;
}
