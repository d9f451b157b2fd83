#include "triangle.h"

// Indices and components by hand.

namespace {
const int ends[3][2] = {{0, 1}, {1, 2}, {2, 0}};

double lengthOf(const Vec9& x, int a, int b) {
  double sum = 0;
  for (int c = 0; c < 3; c++) sum += std::pow(x[3 * a + c] - x[3 * b + c], 2);
  return std::sqrt(sum);
}
}  // namespace

Mat9 massMatrix(const Vec3& m) {
  Mat9 M;
  for (int row = 0; row < 9; row++) {
    for (int col = 0; col < 9; col++) M(row, col) = row == col ? m[row / 3] : 0;
  }
  return M;
}

double triangleEnergy(const Vec9& x, const Vec3& k, const Vec3& L0) {
  double E = 0;
  for (int s = 0; s < 3; s++) E += k[s] / 2 * std::pow(lengthOf(x, ends[s][0], ends[s][1]) - L0[s], 2);
  return E;
}

Vec9 triangleForce(const Vec9& x, const Vec3& k, const Vec3& L0) {
  Vec9 F;
  F.setZero();
  for (int s = 0; s < 3; s++) {
    const int a = ends[s][0];
    const int b = ends[s][1];
    const double L = lengthOf(x, a, b);
    if (L == 0) continue;
    for (int c = 0; c < 3; c++) {
      const double f = k[s] * (L - L0[s]) * (x[3 * b + c] - x[3 * a + c]) / L;
      F[3 * a + c] += f;
      F[3 * b + c] -= f;
    }
  }
  return F;
}
