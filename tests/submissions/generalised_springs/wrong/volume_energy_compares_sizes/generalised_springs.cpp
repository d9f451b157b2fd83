// loses: VolumeEnergy, MinusTheGradient; misconception: absolute_value or sizes_compared
// an inverted tetrahedron of the right size is at rest
#include "generalised_springs.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

using Nodes3 = Eigen::Matrix3d;
using Nodes4 = Eigen::Matrix<double, 3, 4>;

// the segments of the line as columns
static Eigen::Matrix<double, 3, 2> segments(const Vec9& x) {
  const Nodes3 X = Eigen::Map<const Nodes3>(x.data());
  return X.rightCols<2>() - X.leftCols<2>();
}

static Eigen::Matrix3d edges(const Vec12& x) {
  const Nodes4 X = Eigen::Map<const Nodes4>(x.data());
  return X.rightCols<3>().colwise() - X.col(0);
}

double bendingAngle(const Vec9& x) {
  const auto S = segments(x);
  return std::atan2(S.col(0).cross(S.col(1)).norm(), S.col(0).dot(S.col(1)));
}

double bendingEnergy(const Vec9& x, double theta0, double kb) {
  const auto S = segments(x);
  if ((S.colwise().lpNorm<Eigen::Infinity>().array() == 0).any()) return 0;
  const double off = bendingAngle(x) - theta0;
  return kb * off * off / 2;
}

Vec9 bendingForce(const Vec9& x, double theta0, double kb) {
  const auto S = segments(x);
  const Vec3 c = S.col(0).cross(S.col(1));
  const double size = c.norm();
  if (size == 0) return Vec9::Zero();
  Nodes3 G;  // gradient, one node a column
  G.col(0) = (c / size).cross(S.col(0)) / S.col(0).squaredNorm();
  G.col(2) = (c / size).cross(S.col(1)) / S.col(1).squaredNorm();
  G.col(1) = -G.col(0) - G.col(2);
  G *= kb * (theta0 - bendingAngle(x));
  return Eigen::Map<const Vec9>(G.data());
}

double triangleArea(const Vec9& x) {
  const auto S = segments(x);
  return S.col(0).cross(S.col(1)).norm() / 2;
}

double areaEnergy(const Vec9& x, double A0, double kA) {
  const double off = triangleArea(x) - A0;
  return kA * off * off / 2;
}

Vec9 areaForce(const Vec9& x, double A0, double kA) {
  const auto S = segments(x);
  const Vec3 c = S.col(0).cross(S.col(1));
  const double size = c.norm();
  if (size == 0) return Vec9::Zero();
  Nodes3 G;
  G.col(0) = (c / size).cross(S.col(1)) / 2;
  G.col(2) = (c / size).cross(S.col(0)) / 2;
  G.col(1) = -G.col(0) - G.col(2);
  G *= kA * (A0 - triangleArea(x));
  return Eigen::Map<const Vec9>(G.data());
}

double tetrahedronVolume(const Vec12& x) { return edges(x).determinant() / 6; }

double volumeEnergy(const Vec12& x, double V0, double kV) {
  const double off = std::abs(tetrahedronVolume(x)) - std::abs(V0);
  return kV * off * off / 2;
}

Vec12 volumeForce(const Vec12& x, double V0, double kV) {
  const Eigen::Matrix3d E = edges(x);
  Nodes4 G;
  for (int i = 0; i < 3; ++i) G.col(i + 1) = E.col((i + 1) % 3).cross(E.col((i + 2) % 3)) / 6;
  G.col(0) = -G.rightCols<3>().rowwise().sum();
  G *= kV * (V0 - tetrahedronVolume(x));
  return Eigen::Map<const Vec12>(G.data());
}
