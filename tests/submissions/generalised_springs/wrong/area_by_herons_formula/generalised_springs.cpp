// loses: Narrow; misconception: none
// loses the digits of narrow triangles
#include "generalised_springs.h"

#include <Eigen/Geometry>

typedef Eigen::Matrix<long double, 3, 1> V;

namespace {
template <class X>
V at(const X& x, int i) {
  return V(x[3 * i], x[3 * i + 1], x[3 * i + 2]);
}

template <class X>
void put(X& F, int i, const V& f) {
  for (int c = 0; c < 3; ++c) F[3 * i + c] = static_cast<double>(f[c]);
}

long double angleOf(const Vec9& x) {
  const V u = at(x, 1) - at(x, 0), w = at(x, 2) - at(x, 1);
  return std::atan2(u.cross(w).norm(), u.dot(w));
}

V twiceAreaVector(const Vec9& x) { return (at(x, 1) - at(x, 0)).cross(at(x, 2) - at(x, 0)); }
}  // namespace

double bendingAngle(const Vec9& x) { return static_cast<double>(angleOf(x)); }

double bendingEnergy(const Vec9& x, double theta0, double kb) {
  if (at(x, 1) == at(x, 0)) return 0.0;
  if (at(x, 2) == at(x, 1)) return 0.0;
  const long double t = angleOf(x) - theta0;
  return static_cast<double>(kb * t * t / 2);
}

Vec9 bendingForce(const Vec9& x, double theta0, double kb) {
  Vec9 F = Vec9::Zero();
  const V u = at(x, 1) - at(x, 0), w = at(x, 2) - at(x, 1);
  const V c = u.cross(w);
  if (c.norm() == 0) return F;
  const V n = c / c.norm();
  const long double t = kb * (angleOf(x) - theta0);
  const V f0 = -t / u.norm() * n.cross(u / u.norm());
  const V f2 = -t / w.norm() * n.cross(w / w.norm());
  put(F, 0, f0);
  put(F, 1, -f0 - f2);
  put(F, 2, f2);
  return F;
}

double triangleArea(const Vec9& x) {
  const double a = static_cast<double>((at(x, 1) - at(x, 0)).norm());
  const double b = static_cast<double>((at(x, 2) - at(x, 1)).norm());
  const double c = static_cast<double>((at(x, 0) - at(x, 2)).norm());
  const double s = (a + b + c) / 2;
  return std::sqrt(std::max(0.0, s * (s - a) * (s - b) * (s - c)));
}

double areaEnergy(const Vec9& x, double A0, double kA) {
  const long double d = twiceAreaVector(x).norm() / 2 - A0;
  return static_cast<double>(kA * d * d / 2);
}

Vec9 areaForce(const Vec9& x, double A0, double kA) {
  Vec9 F = Vec9::Zero();
  const V c = twiceAreaVector(x);
  const long double twice = c.norm();
  if (twice == 0) return F;
  const long double s = -kA * (twice / 2 - A0) / 2;
  for (int i = 0; i < 3; ++i) put(F, i, s * (c / twice).cross(at(x, (i + 2) % 3) - at(x, (i + 1) % 3)));
  return F;
}

double tetrahedronVolume(const Vec12& x) {
  const V a = at(x, 1) - at(x, 0), b = at(x, 2) - at(x, 0), c = at(x, 3) - at(x, 0);
  return static_cast<double>(c.dot(a.cross(b)) / 6);
}

double volumeEnergy(const Vec12& x, double V0, double kV) {
  const long double d = static_cast<long double>(tetrahedronVolume(x)) - V0;
  return static_cast<double>(kV * d * d / 2);
}

Vec12 volumeForce(const Vec12& x, double V0, double kV) {
  const V a = at(x, 1) - at(x, 0), b = at(x, 2) - at(x, 0), c = at(x, 3) - at(x, 0);
  const long double s = kV * (V0 - tetrahedronVolume(x)) / 6;
  Vec12 F;
  put(F, 1, s * b.cross(c));
  put(F, 2, s * c.cross(a));
  put(F, 3, s * a.cross(b));
  put(F, 0, -s * (b.cross(c) + c.cross(a) + a.cross(b)));
  return F;
}
