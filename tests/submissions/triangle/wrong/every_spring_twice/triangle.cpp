// loses: TriangleEnergy, TriangleForce; misconception: doubled or missing_half
// both loops go over all pairs
#include "triangle.h"

static int springOf(int i, int j) { return (i + 1) % 3 == j ? i : j; }

Mat9 massMatrix(const Vec3& m) {
  Mat9 M = Mat9::Zero();
  for (int i = 0; i < 9; ++i) M(i, i) = m[i / 3];
  return M;
}

double triangleEnergy(const Vec9& x, const Vec3& k, const Vec3& L0) {
  double E = 0.0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      if (i == j) continue;
      const int s = springOf(i, j);
      const double L = (x.segment<3>(3 * i) - x.segment<3>(3 * j)).norm();
      E += 0.5 * k[s] * (L - L0[s]) * (L - L0[s]);
    }
  return E;
}

Vec9 triangleForce(const Vec9& x, const Vec3& k, const Vec3& L0) {
  Vec9 F = Vec9::Zero();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      if (i == j) continue;
      const int s = springOf(i, j);
      const Vec3 d = x.segment<3>(3 * i) - x.segment<3>(3 * j);
      const double L = d.norm();
      if (L == 0) continue;
      const Vec3 f = -k[s] * (L - L0[s]) / L * d;
      F.segment<3>(3 * i) += f;
      F.segment<3>(3 * j) -= f;
    }
  return F;
}
