// loses: TinyLengths; misconception: threshold
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
  const Vec3 r01 = x.segment<3>(0) - x.segment<3>(3);
  const Vec3 r12 = x.segment<3>(3) - x.segment<3>(6);
  const Vec3 r20 = x.segment<3>(6) - x.segment<3>(0);
  const double L01 = r01.norm(), L12 = r12.norm(), L20 = r20.norm();
  Vec3 f01 = Vec3::Zero(), f12 = Vec3::Zero(), f20 = Vec3::Zero();
  if (L01 > 0) f01 = -k[0] * (L01 - L0[0]) * r01 / L01;
  if (L12 > 0) f12 = -k[1] * (L12 - L0[1]) * r12 / L12;
  if (L20 > 1e-12) f20 = -k[2] * (L20 - L0[2]) * r20 / L20;
  Vec9 F;
  F << f01 - f20, f12 - f01, f20 - f12;
  return F;
}
