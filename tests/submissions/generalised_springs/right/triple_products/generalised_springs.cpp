#include "generalised_springs.h"

#include <Eigen/Geometry>

// n x w = ((u x w) x w) / |u x w|: no unit normal.
namespace {

Vec3 edge(const Vec9& x, int from, int to) { return x.segment<3>(3 * to) - x.segment<3>(3 * from); }

}  // namespace

double bendingAngle(const Vec9& x) {
  const Vec3 u = edge(x, 0, 1), w = edge(x, 1, 2);
  return std::atan2(u.cross(w).norm(), u.dot(w));
}

double bendingEnergy(const Vec9& x, double theta0, double kb) {
  const bool hasAngle = edge(x, 0, 1).norm() > 0 && edge(x, 1, 2).norm() > 0;
  return hasAngle ? kb * std::pow(bendingAngle(x) - theta0, 2) / 2 : 0.0;
}

Vec9 bendingForce(const Vec9& x, double theta0, double kb) {
  const Vec3 u = edge(x, 0, 1), w = edge(x, 1, 2), n = u.cross(w);
  if (n.norm() == 0) return Vec9::Zero();
  const double t = kb * (theta0 - bendingAngle(x)) / n.norm();
  Vec9 F = Vec9::Zero();
  F.head<3>() = t * (n.cross(u) / u.squaredNorm());
  F.tail<3>() = t * (n.cross(w) / w.squaredNorm());
  F.segment<3>(3) = -F.head<3>() - F.tail<3>();
  return F;
}

double triangleArea(const Vec9& x) { return edge(x, 2, 0).cross(edge(x, 2, 1)).norm() / 2; }
double areaEnergy(const Vec9& x, double A0, double kA) { return kA * std::pow(triangleArea(x) - A0, 2) / 2; }

Vec9 areaForce(const Vec9& x, double A0, double kA) {
  const Vec3 n = edge(x, 0, 1).cross(edge(x, 0, 2));
  if (n.norm() == 0) return Vec9::Zero();
  const double t = kA * (A0 - triangleArea(x)) / 2;
  Vec9 F;
  F << n.cross(edge(x, 1, 2)), n.cross(edge(x, 2, 0)), n.cross(edge(x, 0, 1));
  return t * (F / n.norm());
}

double tetrahedronVolume(const Vec12& x) {
  const Vec3 o = x.head<3>();
  return (x.segment<3>(3) - o).cross(x.segment<3>(6) - o).dot(x.segment<3>(9) - o) / 6;
}

double volumeEnergy(const Vec12& x, double V0, double kV) { return kV * std::pow(tetrahedronVolume(x) - V0, 2) / 2; }

Vec12 volumeForce(const Vec12& x, double V0, double kV) {
  const double t = kV * (V0 - tetrahedronVolume(x)) / 6;
  const Vec3 o = x.head<3>(), a = x.segment<3>(3) - o, b = x.segment<3>(6) - o, c = x.segment<3>(9) - o;
  Vec12 F = Vec12::Zero();
  F.segment<3>(3) = t * b.cross(c);
  F.segment<3>(6) = t * c.cross(a);
  F.segment<3>(9) = t * a.cross(b);
  for (int i = 1; i < 4; ++i) F.head<3>() -= F.segment<3>(3 * i);
  return F;
}
