// loses: TriangleForce, MinusTheGradient, NewtonsThirdLaw, Equivariance, FreeFlight; misconception: overwrites
#include "triangle.h"

Mat9 massMatrix(const Vec3& m) {
  Mat9 M = Mat9::Zero();
  for (int i = 0; i < 3; ++i) M.block<3, 3>(3 * i, 3 * i).diagonal().fill(m[i]);
  return M;
}

double triangleEnergy(const Vec9& x, const Vec3& k, const Vec3& L0) {
  const double a = (x.segment<3>(0) - x.segment<3>(3)).norm() - L0[0];
  const double b = (x.segment<3>(3) - x.segment<3>(6)).norm() - L0[1];
  const double c = (x.segment<3>(6) - x.segment<3>(0)).norm() - L0[2];
  return 0.5 * (k[0] * a * a + k[1] * b * b + k[2] * c * c);
}

Vec9 triangleForce(const Vec9& x, const Vec3& k, const Vec3& L0) {
  Vec9 F = Vec9::Zero();
  for (int s = 0; s < 3; ++s) {
    const int i = 3 * s, j = 3 * ((s + 1) % 3);
    const Vec3 r = x.segment<3>(i) - x.segment<3>(j);
    const double L = r.norm();
    Vec3 f = Vec3::Zero();
    if (L > 0) f = -k[s] * (L - L0[s]) * r / L;
    F.segment<3>(i) = f;
    F.segment<3>(j) = -f;
  }
  return F;
}
