// loses: TriangleForce, MinusTheGradient, NewtonsThirdLaw, Equivariance, FreeFlight; misconception: absolute_direction
#include "triangle.h"

// which nodes each spring joins
static const int ends[3][2] = {{0, 1}, {1, 2}, {2, 0}};

Mat9 massMatrix(const Vec3& m) {
  Mat9 M = Mat9::Zero();
  for (int row = 0; row < 9; row++) {
    M(row, row) = m(row / 3);
  }
  return M;
}

double triangleEnergy(const Vec9& x, const Vec3& k, const Vec3& L0) {
  double total = 0.0;
  for (int s = 0; s < 3; s++) {
    const Vec3 p = x.segment<3>(3 * ends[s][0]);
    const Vec3 q = x.segment<3>(3 * ends[s][1]);
    const double stretch = (p - q).stableNorm() - L0(s);
    total += 0.5 * k(s) * stretch * stretch;
  }
  return total;
}

Vec9 triangleForce(const Vec9& x, const Vec3& k, const Vec3& L0) {
  Vec9 F = Vec9::Zero();
  for (int s = 0; s < 3; s++) {
    const int i = 3 * ends[s][0];
    const int j = 3 * ends[s][1];
    const Vec3 d = x.segment<3>(j) - x.segment<3>(i);
    const double len = d.stableNorm();
    if (len == 0.0) continue;
    const Vec3 f = k(s) * (len - L0(s)) * (d.cwiseAbs() / len);
    F.segment<3>(i) += f;
    F.segment<3>(j) -= f;
  }
  return F;
}
