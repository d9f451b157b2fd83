// loses: TriangleForce, MinusTheGradient, NewtonsThirdLaw, Equivariance, CoincidentNodes, TinyLengths, FreeFlight; misconception: stateful
#include "triangle.h"

namespace {
Vec9 F = Vec9::Zero();

void addSpring(const Vec9& x, int i, int j, double k, double L0) {
  const Vec3 r = x.segment<3>(3 * i) - x.segment<3>(3 * j);
  const double L = r.norm();
  if (L == 0) return;
  F.segment<3>(3 * i) -= k * (L - L0) * r / L;
  F.segment<3>(3 * j) += k * (L - L0) * r / L;
}
}  // namespace

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
  addSpring(x, 0, 1, k[0], L0[0]);
  addSpring(x, 1, 2, k[1], L0[1]);
  addSpring(x, 2, 0, k[2], L0[2]);
  return F;
}
