// loses: TriangleEnergy, MinusTheGradient, Equivariance, CoincidentNodes, TinyLengths, FreeFlight; misconception: integer_division or zero
#include "triangle.h"

Mat9 massMatrix(const Vec3& m) {
  Mat9 M = Mat9::Zero();
  for (int i = 0; i < 9; ++i) M(i, i) = m[i / 3];
  return M;
}

double triangleEnergy(const Vec9& x, const Vec3& k, const Vec3& L0) {
  double E = 0;
  for (int s = 0; s < 3; ++s) {
    Vec3 d = x.segment<3>(3 * s) - x.segment<3>(3 * ((s + 1) % 3));
    E += 1 / 2 * k[s] * std::pow(d.norm() - L0[s], 2);
  }
  return E;
}

Vec9 triangleForce(const Vec9& x, const Vec3& k, const Vec3& L0) {
  Vec9 F = Vec9::Zero();
  for (int s = 0; s < 3; ++s) {
    int t = (s + 1) % 3;
    Vec3 d = x.segment<3>(3 * s) - x.segment<3>(3 * t);
    double L = d.norm();
    if (L > 0) {
      Vec3 f = k[s] * (L - L0[s]) * d / L;
      F.segment<3>(3 * s) -= f;
      F.segment<3>(3 * t) += f;
    }
  }
  return F;
}
