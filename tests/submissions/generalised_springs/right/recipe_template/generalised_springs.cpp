#include "generalised_springs.h"

#include <Eigen/Geometry>

// One recipe: a number, its gradient, a rest value.
namespace {

template <class Vector>
Vector forceOf(double p, double rest, double k, const Vector& gradient) {
  return -k * (p - rest) * gradient;
}
double energyOf(double p, double rest, double k) { return 0.5 * k * (p - rest) * (p - rest); }

struct Bend {
  Vec3 u, w, n;
  double s;
  explicit Bend(const Vec9& x)
      : u(x.segment<3>(3) - x.segment<3>(0)), w(x.segment<3>(6) - x.segment<3>(3)), n(u.cross(w)), s(n.norm()) {
    if (s > 0) n /= s;
  }
  Vec9 gradient() const {
    if (s == 0) return Vec9::Zero();
    const Vec3 du = u.cross(n) / u.dot(u), dw = n.cross(w) / w.dot(w);
    return (Vec9() << -du, du - dw, dw).finished();
  }
};

Vec9 areaGradient(const Vec9& x) {
  const Vec3 u = x.segment<3>(3) - x.segment<3>(0), w = x.segment<3>(6) - x.segment<3>(0);
  const double s = u.cross(w).norm();
  if (s == 0) return Vec9::Zero();
  const Vec3 n = u.cross(w) / s;
  // A = n . (u x w) / 2, and n is at right angles to its own change.
  const Vec3 du = w.cross(n) / 2, dw = n.cross(u) / 2;
  return (Vec9() << -du - dw, du, dw).finished();
}

Vec12 volumeGradient(const Vec12& x) {
  Eigen::Matrix3d E;
  for (int i = 0; i < 3; ++i) E.col(i) = x.segment<3>(3 * i + 3) - x.head<3>();
  Vec12 g = Vec12::Zero();
  for (int i = 0; i < 3; ++i) {
    const Vec3 face = E.col((i + 1) % 3).cross(E.col((i + 2) % 3)) / 6;
    g.segment<3>(3 * i + 3) = face;
    g.head<3>() -= face;
  }
  return g;
}

}  // namespace

double bendingAngle(const Vec9& x) {
  const Bend b(x);
  return std::atan2(b.s, b.u.dot(b.w));
}
double bendingEnergy(const Vec9& x, double theta0, double kb) {
  const Bend b(x);
  return b.u.isZero(0) || b.w.isZero(0) ? 0.0 : energyOf(bendingAngle(x), theta0, kb);
}
Vec9 bendingForce(const Vec9& x, double theta0, double kb) {
  return forceOf(bendingAngle(x), theta0, kb, Bend(x).gradient());
}
double triangleArea(const Vec9& x) { return Vec3(x.segment<3>(3) - x.head<3>()).cross(x.tail<3>() - x.head<3>()).norm() / 2; }
double areaEnergy(const Vec9& x, double A0, double kA) { return energyOf(triangleArea(x), A0, kA); }
Vec9 areaForce(const Vec9& x, double A0, double kA) { return forceOf(triangleArea(x), A0, kA, areaGradient(x)); }
double tetrahedronVolume(const Vec12& x) { return volumeGradient(x).tail<3>().dot(x.tail<3>() - x.head<3>()); }
double volumeEnergy(const Vec12& x, double V0, double kV) { return energyOf(tetrahedronVolume(x), V0, kV); }
Vec12 volumeForce(const Vec12& x, double V0, double kV) {
  return forceOf(tetrahedronVolume(x), V0, kV, volumeGradient(x));
}
