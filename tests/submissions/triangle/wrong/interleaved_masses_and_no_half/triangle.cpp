// loses: MassMatrix, TriangleEnergy, MinusTheGradient, FreeFlight; misconception: masses_interleaved or missing_half or doubled
// two mistakes: m0 m1 m2 three times along the diagonal, and no 1/2 in the energy
#include "triangle.h"

Mat9 massMatrix(const Vec3& m) {
  Mat9 M = Mat9::Zero();
  for (int i = 0; i < 9; i++) M(i, i) = m[i % 3];
  return M;
}

double triangleEnergy(const Vec9& x, const Vec3& k, const Vec3& L0) {
  double E = 0;
  for (int i = 0; i < 3; i++) {
    int j = (i + 1) % 3;
    double L = (x.segment<3>(3 * i) - x.segment<3>(3 * j)).norm();
    E += k[i] * (L - L0[i]) * (L - L0[i]);
  }
  return E;
}

Vec9 triangleForce(const Vec9& x, const Vec3& k, const Vec3& L0) {
  Vec9 F = Vec9::Zero();
  for (int i = 0; i < 3; i++) {
    int j = (i + 1) % 3;
    Vec3 d = x.segment<3>(3 * i) - x.segment<3>(3 * j);
    double L = d.norm();
    if (L == 0) continue;
    F.segment<3>(3 * i) -= k[i] * (L - L0[i]) * d / L;
    F.segment<3>(3 * j) += k[i] * (L - L0[i]) * d / L;
  }
  return F;
}
