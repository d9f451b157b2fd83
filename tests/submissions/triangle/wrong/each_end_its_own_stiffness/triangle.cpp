// loses: TriangleForce, MinusTheGradient, NewtonsThirdLaw, Equivariance, FreeFlight; misconception: stiffness_by_node
// node i pulls with k[i] on both its springs; the rest length is that of the spring
#include "triangle.h"

Mat9 massMatrix(const Vec3& m) {
  Mat9 M = Mat9::Zero();
  for (int i = 0; i < 3; ++i) M.block<3, 3>(3 * i, 3 * i) = Vec3::Constant(m[i]).asDiagonal();
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
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (i == j) continue;
      const int spring = (i + 1) % 3 == j ? i : j;
      const Vec3 r = x.segment<3>(3 * i) - x.segment<3>(3 * j);
      const double L = r.norm();
      if (L > 0) F.segment<3>(3 * i) += -k[i] * (L - L0[spring]) * r / L;
    }
  }
  return F;
}
