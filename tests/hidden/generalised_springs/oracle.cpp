/// \file
/// The expected values, another way: the angle's gradient by the components of each segment along the other, the area's
/// by what is left of an edge at right angles to the opposite side, the volume by a determinant and its cofactors.

#include "generalised_springs.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace {

Vec3 node(const Eigen::VectorXd& x, int i) { return x.segment<3>(3 * i); }
double lengthOf(const Vec3& d) { return std::hypot(d[0], d[1], d[2]); }

/// Written out, so that each component is one difference of products.
Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The triple product a x b x c as the vector at right angles to c in the plane of a and b, of length |a x b| |c|.
Vec3 inThePlane(const Vec3& a, const Vec3& b, const Vec3& c) { return cross(cross(a, b), c); }

Eigen::Matrix3d edges(const Vec12& x) {
  Eigen::Matrix3d sides;
  for (int i = 0; i < 3; ++i) sides.col(i) = node(x, i + 1) - node(x, 0);
  return sides;
}

}  // namespace

namespace oracle {

double bendingAngle(const Vec9& x) {
  const Vec3 u = node(x, 1) - node(x, 0), w = node(x, 2) - node(x, 1);
  return std::atan2(lengthOf(cross(u, w)), u[0] * w[0] + u[1] * w[1] + u[2] * w[2]);
}

double bendingEnergy(const Vec9& x, double theta0, double kb) {
  const bool hasAngle = lengthOf(node(x, 1) - node(x, 0)) > 0 && lengthOf(node(x, 2) - node(x, 1)) > 0;
  return hasAngle ? kb / 2 * std::pow(given::bendingAngle(x) - theta0, 2) : 0.0;
}

Vec9 bendingForce(const Vec9& x, double theta0, double kb) {
  const Vec3 u = node(x, 1) - node(x, 0), w = node(x, 2) - node(x, 1);
  const double s = lengthOf(cross(u, w));
  if (s == 0) return Vec9::Zero();
  const double torque = kb * (theta0 - given::bendingAngle(x));
  // Each end is pushed at right angles to its segment, with the torque over its length; the middle takes the opposite.
  const Vec3 first = torque / s * (inThePlane(u, w, u) / u.squaredNorm());
  const Vec3 last = torque / s * (inThePlane(u, w, w) / w.squaredNorm());
  Vec9 F;
  F << first, -first - last, last;
  return F;
}

double triangleArea(const Vec9& x) { return lengthOf(cross(node(x, 0) - node(x, 2), node(x, 1) - node(x, 2))) / 2; }

double areaEnergy(const Vec9& x, double A0, double kA) { return kA / 2 * std::pow(given::triangleArea(x) - A0, 2); }

Vec9 areaForce(const Vec9& x, double A0, double kA) {
  const Vec3 u = node(x, 1) - node(x, 0), w = node(x, 2) - node(x, 0);
  const double twice = lengthOf(cross(u, w));
  Vec9 F = Vec9::Zero();
  if (twice == 0) return F;
  const double pressure = kA * (A0 - given::triangleArea(x));
  const std::array<Vec3, 3> side = {w - u, -w, u};  // opposite to node 0, 1, 2
  for (int i = 0; i < 3; ++i) {
    F.segment<3>(3 * i) = pressure / 2 * (inThePlane(u, w, side[static_cast<std::size_t>(i)]) / twice);
  }
  return F;
}

double tetrahedronVolume(const Vec12& x) { return edges(x).determinant() / 6; }

double volumeEnergy(const Vec12& x, double V0, double kV) {
  return kV / 2 * std::pow(given::tetrahedronVolume(x) - V0, 2);
}

Vec12 volumeForce(const Vec12& x, double V0, double kV) {
  const double pressure = kV * (V0 - given::tetrahedronVolume(x));
  const Eigen::Matrix3d E = edges(x);
  Vec12 F = Vec12::Zero();
  for (int i = 0; i < 3; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      const int a = (axis + 1) % 3, b = (axis + 2) % 3, p = (i + 1) % 3, q = (i + 2) % 3;
      const double cofactor = E(a, p) * E(b, q) - E(a, q) * E(b, p);
      F[3 * (i + 1) + axis] = pressure * cofactor / 6;
      F[axis] -= pressure * cofactor / 6;
    }
  }
  return F;
}

}  // namespace oracle
