// loses: TriangleEnergy, MinusTheGradient, Equivariance, FreeFlight; misconception: two_springs
#include "triangle.h"

Mat9 massMatrix(const Vec3& m) {
  Mat9 M = Mat9::Zero();
  auto put = [&](int node) {
    for (int c = 0; c < 3; ++c) M(3 * node + c, 3 * node + c) = m[node];
  };
  put(0);
  put(1);
  put(2);
  return M;
}

double triangleEnergy(const Vec9& x, const Vec3& k, const Vec3& L0) {
  auto energy = [&](int i, int j, int s) {
    double L = (x.segment<3>(3 * i) - x.segment<3>(3 * j)).stableNorm();
    double u = L - L0[s];
    return 0.5 * k[s] * u * u;
  };
  return energy(0, 1, 0) + energy(1, 2, 1);
}

Vec9 triangleForce(const Vec9& x, const Vec3& k, const Vec3& L0) {
  Vec9 F = Vec9::Zero();
  auto addSpring = [&](int i, int j, int s) {
    Vec3 d = x.segment<3>(3 * i) - x.segment<3>(3 * j);
    double L = d.stableNorm();
    if (L == 0) return;  // leaves the lambda only
    Vec3 onI = -k[s] * (L - L0[s]) * (d / L);
    F.segment<3>(3 * i) += onI;
    F.segment<3>(3 * j) -= onI;
  };
  addSpring(0, 1, 0);
  addSpring(1, 2, 1);
  addSpring(2, 0, 2);
  return F;
}
