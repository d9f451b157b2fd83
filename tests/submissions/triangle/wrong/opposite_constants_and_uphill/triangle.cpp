// loses: TriangleForce, MinusTheGradient, Equivariance, FreeFlight; misconception: none
// two mistakes: k[i], L0[i] of the side opposite to node i, and plus the gradient
#include "triangle.h"

Mat9 massMatrix(const Vec3& m) {
  Mat9 M = Mat9::Zero();
  M.diagonal().segment<3>(0).setConstant(m[0]);
  M.diagonal().segment<3>(3).setConstant(m[1]);
  M.diagonal().segment<3>(6).setConstant(m[2]);
  return M;
}

double triangleEnergy(const Vec9& x, const Vec3& k, const Vec3& L0) {
  double E = 0.0;
  for (int s = 0; s < 3; ++s) {
    const Vec3 a = x.segment<3>(3 * s), b = x.segment<3>(3 * ((s + 1) % 3));
    const double stretch = (a - b).norm() - L0[s];
    E += 0.5 * k[s] * stretch * stretch;
  }
  return E;
}

Vec9 triangleForce(const Vec9& x, const Vec3& k, const Vec3& L0) {
  Vec9 F = Vec9::Zero();
  for (int corner = 0; corner < 3; ++corner) {
    // the side opposite to this corner
    const int p = (corner + 1) % 3, q = (corner + 2) % 3;
    const Vec3 r = x.segment<3>(3 * p) - x.segment<3>(3 * q);
    const double L = r.norm();
    if (L == 0) continue;
    const Vec3 f = k[corner] * (L - L0[corner]) * r / L;
    F.segment<3>(3 * p) += f;
    F.segment<3>(3 * q) -= f;
  }
  return F;
}
