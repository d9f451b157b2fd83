// loses: TriangleForce, MinusTheGradient; misconception: whole_numbers or integer_division
#include "triangle.h"

// One column for each node.
Mat9 massMatrix(const Vec3& m) {
  Mat3 diagonals;
  diagonals.rowwise() = m.transpose();
  const Vec9 stacked = Eigen::Map<const Vec9>(diagonals.data());
  Mat9 M = Mat9::Zero();
  M.diagonal() = stacked;
  return M;
}

double triangleEnergy(const Vec9& x, const Vec3& k, const Vec3& L0) {
  const Mat3 X = Eigen::Map<const Mat3>(x.data());
  const double s0 = (X.col(1) - X.col(0)).stableNorm() - L0.x();
  const double s1 = (X.col(2) - X.col(1)).stableNorm() - L0.y();
  const double s2 = (X.col(0) - X.col(2)).stableNorm() - L0.z();
  return (k.x() * s0 * s0 + k.y() * s1 * s1 + k.z() * s2 * s2) / 2.0;
}

Vec9 triangleForce(const Vec9& x, const Vec3& k, const Vec3& L0) {
  const Mat3 X = Eigen::Map<const Mat3>(x.data());
  Mat3 F = Mat3::Zero();
  for (int s = 0; s < 3; ++s) {
    const int t = s == 2 ? 0 : s + 1;
    const Vec3 d = X.col(t) - X.col(s);
    const double L = d.stableNorm();
    const int ks = k[s];
    const Vec3 u = L > 0 ? Vec3(d / L) : Vec3(0, 0, 0);
    F.col(s) += ks * (L - L0[s]) * u;
    F.col(t) -= ks * (L - L0[s]) * u;
  }
  return Eigen::Map<const Vec9>(F.data());
}
