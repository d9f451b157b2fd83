// loses: TriangleEnergy, MinusTheGradient, Equivariance, CoincidentNodes, TinyLengths, FreeFlight; misconception: stateful
#include "triangle.h"

Mat9 massMatrix(const Vec3& m) {
  Mat9 M = Mat9::Zero();
  for (int i = 0; i < 3; ++i) {
    M(3 * i, 3 * i) = M(3 * i + 1, 3 * i + 1) = M(3 * i + 2, 3 * i + 2) = m[i];
  }
  return M;
}

double triangleEnergy(const Vec9& x, const Vec3& k, const Vec3& L0) {
  static double twice = 0.0;
  for (int i = 0, j = 1; i < 3; ++i, j = (j + 1) % 3) {
    const double L = (x.segment<3>(3 * i) - x.segment<3>(3 * j)).norm();
    twice += k[i] * std::pow(L - L0[i], 2);
  }
  return twice / 2;
}

Vec9 triangleForce(const Vec9& x, const Vec3& k, const Vec3& L0) {
  Vec9 F = Vec9::Zero();
  for (int i = 0, j = 1; i < 3; ++i, j = (j + 1) % 3) {
    const Vec3 r = x.segment<3>(3 * i) - x.segment<3>(3 * j);
    const double L = r.norm();
    if (L > 0) {
      // k (L0 - L) / L
      const double c = k[i] * (L0[i] / L - 1);
      F.segment<3>(3 * i) += c * r;
      F.segment<3>(3 * j) -= c * r;
    }
  }
  return F;
}
