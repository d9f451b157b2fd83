// loses: TriangleForce, MinusTheGradient, NewtonsThirdLaw, Equivariance, FreeFlight; misconception: without_reaction
#include "triangle.h"

static Vec3 hooke(const Vec3& a, const Vec3& b, double k, double L0) {
  const double L = (a - b).norm();
  if (L == 0) return Vec3::Zero();
  return -k * (L - L0) * (a - b) / L;
}

Mat9 massMatrix(const Vec3& m) {
  Mat9 M = Mat9::Zero();
  for (int i = 0; i < 9; ++i) M(i, i) = m[i / 3];
  return M;
}

double triangleEnergy(const Vec9& x, const Vec3& k, const Vec3& L0) {
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    const double L = (x.segment<3>(3 * i) - x.segment<3>(3 * ((i + 1) % 3))).norm();
    sum += 0.5 * k[i] * (L - L0[i]) * (L - L0[i]);
  }
  return sum;
}

Vec9 triangleForce(const Vec9& x, const Vec3& k, const Vec3& L0) {
  const Vec3 x0 = x.segment<3>(0), x1 = x.segment<3>(3), x2 = x.segment<3>(6);
  Vec9 F;
  F << hooke(x0, x1, k[0], L0[0]), hooke(x1, x2, k[1], L0[1]), hooke(x2, x0, k[2], L0[2]);
  return F;
}
