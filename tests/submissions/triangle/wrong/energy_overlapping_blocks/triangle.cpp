// loses: TriangleEnergy, MinusTheGradient, Equivariance, FreeFlight; misconception: wrong_block
#include "triangle.h"

Mat9 massMatrix(const Vec3& m) {
  Mat9 M = Mat9::Zero();
  for (int r = 8; r >= 0; --r) M(r, r) = m[r / 3];
  return M;
}

double triangleEnergy(const Vec9& x, const Vec3& k, const Vec3& L0) {
  double E = 0.0;
  for (int s = 2; s >= 0; --s) {
    const double L = (x.segment<3>((s + 1) % 3) - x.segment<3>(s)).stableNorm();
    E += 0.5 * k[s] * (L0[s] - L) * (L0[s] - L);
  }
  return E;
}

Vec9 triangleForce(const Vec9& x, const Vec3& k, const Vec3& L0) {
  Vec9 F = Vec9::Zero();
  for (int s = 2; s >= 0; --s) {
    auto here = F.segment<3>(3 * s);
    auto there = F.segment<3>(3 * ((s + 1) % 3));
    const Vec3 r = x.segment<3>(3 * ((s + 1) % 3)) - x.segment<3>(3 * s);
    const double L = r.stableNorm();
    const double divisor = L > 0 ? L : 1.0;
    const Vec3 tension = k[s] * (L - L0[s]) * (r / divisor);
    here += tension;
    there -= tension;
  }
  return F;
}
