#include "triangle.h"

// Nodes as the columns of a 3 x 3 matrix; P moves each column one place to the left, so X - X P holds x_i - x_{i+1}.
static Mat3 shift() {
  Mat3 P;
  P << 0, 0, 1,
       1, 0, 0,
       0, 1, 0;
  return P;
}

static Mat3 sides(const Vec9& x) {
  const Mat3 X = Eigen::Map<const Mat3>(x.data());
  return X - X * shift();
}

Mat9 massMatrix(const Vec3& m) {
  return (Vec9() << Vec3::Constant(m[0]), Vec3::Constant(m[1]), Vec3::Constant(m[2])).finished().asDiagonal();
}

double triangleEnergy(const Vec9& x, const Vec3& k, const Vec3& L0) {
  const Vec3 stretch = sides(x).colwise().norm().transpose() - L0;
  return 0.5 * stretch.cwiseAbs2().dot(k);
}

Vec9 triangleForce(const Vec9& x, const Vec3& k, const Vec3& L0) {
  Mat3 pull = sides(x);  // becomes the force of spring s on its second node
  for (int s = 0; s < 3; ++s) {
    const double L = pull.col(s).stableNorm();
    if (L > 0) pull.col(s) *= 1.0 / L;
    pull.col(s) *= k[s] * (L - L0[s]);
  }
  const Mat3 F = pull * shift().transpose() - pull;
  return Eigen::Map<const Vec9>(F.data());
}
