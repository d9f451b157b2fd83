// loses: TriangleForce, MinusTheGradient, Equivariance, FreeFlight; misconception: one_rest_length or first_for_all
#include "triangle.h"

Mat9 massMatrix(const Vec3& m) {
  Mat9 M = Mat9::Zero();
  for (int i = 0; i < 9; ++i) M(i, i) = m[i / 3];
  return M;
}

double triangleEnergy(const Vec9& x, const Vec3& k, const Vec3& L0) {
  double E = 0;
  for (int s = 0; s < 3; ++s) {
    const double L = (x.segment<3>(3 * s) - x.segment<3>(3 * ((s + 1) % 3))).norm();
    E += 0.5 * k[s] * (L - L0[s]) * (L - L0[s]);
  }
  return E;
}

Vec9 triangleForce(const Vec9& x, const Vec3& k, const Vec3& L0) {
  const double* rest = L0.data();
  Vec9 F = Vec9::Zero();
  for (int s = 0; s < 3; ++s) {
    const int i = 3 * s, j = (3 * s + 3) % 9;
    const Vec3 r = x.segment<3>(j) - x.segment<3>(i);
    const double L = r.norm();
    if (L == 0) continue;
    F.segment<3>(i) += k[s] * (L - *rest) * r / L;
    F.segment<3>(j) -= k[s] * (L - *rest) * r / L;
  }
  return F;
}
