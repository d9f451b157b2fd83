// loses: TriangleEnergy, TriangleForce, Equivariance; misconception: springs_reordered
// 01, 02, 12
#include "triangle.h"

// spring between nodes i and j: 01 -> 0, 02 -> 1, 12 -> 2
static int springBetween(int i, int j) {
  if (i + j == 1) return 0;
  if (i + j == 2) return 1;
  return 2;
}

Mat9 massMatrix(const Vec3& m) {
  Mat9 M = Mat9::Zero();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (i == j) M.block<3, 3>(3 * i, 3 * j) += m[i] * Mat3::Identity();
  return M;
}

double triangleEnergy(const Vec9& x, const Vec3& k, const Vec3& L0) {
  double E = 0.0;
  for (int i = 0; i < 3; ++i) {
    for (int j = i + 1; j < 3; ++j) {
      const int s = springBetween(i, j);
      const double deformation = (x.segment<3>(3 * i) - x.segment<3>(3 * j)).stableNorm() - L0[s];
      E += 0.5 * k[s] * deformation * deformation;
    }
  }
  return E;
}

Vec9 triangleForce(const Vec9& x, const Vec3& k, const Vec3& L0) {
  Vec9 F = Vec9::Zero();
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (i == j) continue;
      const int s = springBetween(i, j);
      const Vec3 d = x.segment<3>(3 * j) - x.segment<3>(3 * i);
      const double L = d.stableNorm();
      if (L > 0) F.segment<3>(3 * i) += k[s] * (L - L0[s]) * (d / L);
    }
  }
  return F;
}
