// nodes as the columns of a matrix, the volume a determinant, its gradient the cofactors
#include "generalised_springs.h"

#include <Eigen/Dense>

using Nodes3 = Eigen::Matrix<double, 3, 3>;
using Nodes4 = Eigen::Matrix<double, 3, 4>;

static Nodes3 columns(const Vec9& x) { return Eigen::Map<const Nodes3>(x.data()); }
static Nodes4 columns(const Vec12& x) { return Eigen::Map<const Nodes4>(x.data()); }

double bendingAngle(const Vec9& x) {
  const Nodes3 X = columns(x);
  const Vec3 u = X.col(1) - X.col(0);
  const Vec3 w = X.col(2) - X.col(1);
  if (u.isZero(0) || w.isZero(0)) return 0.0;
  return std::atan2(u.cross(w).stableNorm(), u.transpose() * w);
}

double bendingEnergy(const Vec9& x, double theta0, double kb) {
  const Nodes3 X = columns(x);
  if (X.col(0) == X.col(1) || X.col(1) == X.col(2)) return 0.0;
  const double theta = bendingAngle(x);
  return 0.5 * kb * (theta0 - theta) * (theta0 - theta);
}

Vec9 bendingForce(const Vec9& x, double theta0, double kb) {
  const Nodes3 X = columns(x);
  const Vec3 u = X.col(1) - X.col(0);
  const Vec3 w = X.col(2) - X.col(1);
  const Vec3 n = u.cross(w);
  Nodes3 F = Nodes3::Zero();
  if (!n.isZero(0)) {
    const Vec3 unit = n.stableNormalized();
    const double back = kb * (theta0 - bendingAngle(x));
    const Vec3 onU = back * u.cross(unit) / u.squaredNorm();
    const Vec3 onW = back * unit.cross(w) / w.squaredNorm();
    F.col(0) -= onU;
    F.col(1) += onU;
    F.col(1) -= onW;
    F.col(2) += onW;
  }
  return Eigen::Map<Vec9>(F.data());
}

double triangleArea(const Vec9& x) {
  const Nodes3 X = columns(x);
  const Vec3 u = X.col(0) - X.col(2);
  const Vec3 w = X.col(1) - X.col(2);
  return u.cross(w).stableNorm() * 0.5;
}

double areaEnergy(const Vec9& x, double A0, double kA) {
  const double missing = A0 - triangleArea(x);
  return kA * missing * missing / 2.0;
}

Vec9 areaForce(const Vec9& x, double A0, double kA) {
  const Nodes3 X = columns(x);
  const Vec3 n = (X.col(0) - X.col(2)).cross(X.col(1) - X.col(2));
  Nodes3 F = Nodes3::Zero();
  if (!n.isZero(0)) {
    const Vec3 unit = n.stableNormalized();
    const double back = 0.5 * kA * (A0 - triangleArea(x));
    F.col(0) = back * unit.cross(X.col(2) - X.col(1));
    F.col(1) = back * unit.cross(X.col(0) - X.col(2));
    F.col(2) = back * unit.cross(X.col(1) - X.col(0));
  }
  return Eigen::Map<Vec9>(F.data());
}

double tetrahedronVolume(const Vec12& x) {
  const Nodes4 X = columns(x);
  Nodes3 edges;
  for (int i = 0; i < 3; ++i) edges.col(i) = X.col(i + 1) - X.col(0);
  return edges.determinant() / 6.0;
}

double volumeEnergy(const Vec12& x, double V0, double kV) {
  const double missing = V0 - tetrahedronVolume(x);
  return kV * missing * missing / 2.0;
}

Vec12 volumeForce(const Vec12& x, double V0, double kV) {
  const Nodes4 X = columns(x);
  Nodes3 edges;
  for (int i = 0; i < 3; ++i) edges.col(i) = X.col(i + 1) - X.col(0);
  Nodes4 gradient;
  gradient.col(0).setZero();
  for (int i = 0; i < 3; ++i) {
    const Vec3 cofactor = edges.col((i + 1) % 3).cross(edges.col((i + 2) % 3)) / 6.0;
    gradient.col(i + 1) = cofactor;
    gradient.col(0) -= cofactor;
  }
  gradient *= kV * (V0 - tetrahedronVolume(x));
  return Eigen::Map<Vec12>(gradient.data());
}
