// loses: TriangleForce, TinyLengths; misconception: difference_quotient
#include "triangle.h"

Mat9 massMatrix(const Vec3& m) {
  Mat9 M = Mat9::Zero();
  for (int i = 0; i < 9; ++i) M(i, i) = m[i / 3];
  return M;
}

double triangleEnergy(const Vec9& x, const Vec3& k, const Vec3& L0) {
  double E = 0.0;
  for (int s = 0; s < 3; ++s) {
    const double L = (x.segment<3>(3 * s) - x.segment<3>(3 * ((s + 1) % 3))).norm();
    E += 0.5 * k[s] * (L - L0[s]) * (L - L0[s]);
  }
  return E;
}

Vec9 triangleForce(const Vec9& x, const Vec3& k, const Vec3& L0) {
  const double h = 1e-6;
  Vec9 F;
  for (int i = 0; i < 9; ++i) {
    Vec9 a = x, b = x;
    a[i] += h;
    b[i] -= h;
    F[i] = -(triangleEnergy(a, k, L0) - triangleEnergy(b, k, L0)) / (2 * h);
  }
  return F;
}
