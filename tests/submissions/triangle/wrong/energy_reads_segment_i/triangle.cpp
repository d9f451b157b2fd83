// loses: TriangleEnergy, MinusTheGradient, Equivariance, FreeFlight; misconception: wrong_block
#include "triangle.h"

Mat9 massMatrix(const Vec3& m) {
  Mat9 M = Mat9::Zero();
  for (int i = 0; i < 9; ++i) M(i, i) = m[i / 3];
  return M;
}

double triangleEnergy(const Vec9& x, const Vec3& k, const Vec3& L0) {
  double E = 0;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const double L = (x.segment<3>(i) - x.segment<3>(j)).norm();
    E += 0.5 * k[i] * (L - L0[i]) * (L - L0[i]);
  }
  return E;
}

Vec9 triangleForce(const Vec9& x, const Vec3& k, const Vec3& L0) {
  Vec9 F = Vec9::Zero();
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const Vec3 r = x.segment<3>(3 * i) - x.segment<3>(3 * j);
    const double L = r.norm();
    if (L == 0) continue;
    const Vec3 f = k[i] * (L - L0[i]) * r / L;
    F.segment<3>(3 * i) -= f;
    F.segment<3>(3 * j) += f;
  }
  return F;
}
