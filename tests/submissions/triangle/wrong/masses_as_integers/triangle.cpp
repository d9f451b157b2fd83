// loses: MassMatrix; misconception: cut_result
// the masses go through an array of int: 1.5 kg becomes 1, a gram becomes 0
#include "triangle.h"

Mat9 massMatrix(const Vec3& m) {
  const std::array<int, 3> mass = {(int)m[0], (int)m[1], (int)m[2]};
  Mat9 M = Mat9::Zero();
  for (int i = 0; i < 9; ++i) M(i, i) = mass[i / 3];
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
  Vec9 F = Vec9::Zero();
  for (int s = 0; s < 3; ++s) {
    const int i = 3 * s, j = 3 * ((s + 1) % 3);
    const Vec3 r = x.segment<3>(i) - x.segment<3>(j);
    const double L = r.norm();
    if (L == 0) continue;
    const Vec3 f = k[s] * (L0[s] - L) * r / L;
    F.segment<3>(i) += f;
    F.segment<3>(j) -= f;
  }
  return F;
}
