// loses: TriangleForce, MinusTheGradient, Equivariance, FreeFlight; misconception: two_springs or last_skipped
// i and i + 1, as for a chain: no spring from node 2 back to node 0
#include "triangle.h"

Mat9 massMatrix(const Vec3& m) {
  Mat9 M = Mat9::Zero();
  for (int i = 0; i < 3; ++i)
    for (int c = 0; c < 3; ++c) M(3 * i + c, 3 * i + c) = m[i];
  return M;
}

double triangleEnergy(const Vec9& x, const Vec3& k, const Vec3& L0) {
  double E = 0;
  for (int s = 0; s < 3; ++s) {
    const double L = (x.segment<3>(3 * s) - x.segment<3>((3 * s + 3) % 9)).norm();
    E += k[s] / 2 * (L - L0[s]) * (L - L0[s]);
  }
  return E;
}

Vec9 triangleForce(const Vec9& x, const Vec3& k, const Vec3& L0) {
  Vec9 F = Vec9::Zero();
  for (int i = 0; i + 1 < 3; ++i) {
    const Vec3 r = x.segment<3>(3 * i) - x.segment<3>(3 * i + 3);
    const double L = r.norm();
    if (L == 0.0) continue;
    const Vec3 f = -k[i] * (L - L0[i]) / L * r;
    F.segment<3>(3 * i) += f;
    F.segment<3>(3 * i + 3) -= f;
  }
  return F;
}
