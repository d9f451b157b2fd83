/// \file
/// The expected values, in matrix form: the signed incidence matrix D of the triangle maps positions to the differences
/// d of the springs, and its transpose maps the springs' tensions back to the nodes, f = -D^T (k (1 - L0 / L) d).

#include "triangle.h"

namespace {

/// One row a spring (01, 12, 20), one column a node: +1 at the first node, -1 at the second.
Mat3 incidence() {
  Mat3 D;
  D << 1, -1, 0,  //
      0, 1, -1,   //
      -1, 0, 1;
  return D;
}

/// One row a spring: its difference of positions.
Mat3 differences(const Vec9& x) {
  const Mat3 nodes = Eigen::Map<const Mat3>(x.data()).transpose();  // one row a node
  return incidence() * nodes;
}

/// The length of a row, without underflow in the squares.
double lengthOf(const Mat3& d, int spring) { return std::hypot(d(spring, 0), d(spring, 1), d(spring, 2)); }

}  // namespace

namespace oracle {

Mat9 massMatrix(const Vec3& m) {
  Vec9 diagonal;
  for (int c = 0; c < 9; ++c) diagonal[c] = m[c / 3];
  return diagonal.asDiagonal();
}

double triangleEnergy(const Vec9& x, const Vec3& k, const Vec3& L0) {
  const Mat3 d = differences(x);
  Vec3 stretch;
  for (int s = 0; s < 3; ++s) stretch[s] = lengthOf(d, s) - L0[s];
  return stretch.dot(k.cwiseProduct(stretch)) / 2;
}

Vec9 triangleForce(const Vec9& x, const Vec3& k, const Vec3& L0) {
  const Mat3 d = differences(x);
  Mat3 tension = Mat3::Zero();
  for (int s = 0; s < 3; ++s) {
    const double L = lengthOf(d, s);
    if (L > 0) tension.row(s) = k[s] * (1 - L0[s] / L) * d.row(s);
  }
  const Mat3 forces = (-incidence().transpose() * tension).transpose();  // one column a node
  return Eigen::Map<const Vec9>(forces.data());
}

}  // namespace oracle
