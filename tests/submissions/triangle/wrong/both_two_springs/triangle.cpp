// loses: TriangleEnergy, TriangleForce, Equivariance; misconception: two_springs
// the recursion ends one spring too early
#include "triangle.h"

static double energyFrom(int s, const Vec9& x, const Vec3& k, const Vec3& L0) {
  if (s == 2) return 0.0;
  const int i = 3 * s;
  const int j = (i + 3) % 9;
  const double u = (x.segment<3>(i) - x.segment<3>(j)).blueNorm() - L0[s];
  return 0.5 * k[s] * u * u + energyFrom(s + 1, x, k, L0);
}

static Vec9 forceFrom(int s, const Vec9& x, const Vec3& k, const Vec3& L0) {
  if (s == 2) return Vec9::Zero();
  Vec9 F = forceFrom(s + 1, x, k, L0);
  const int i = 3 * s;
  const int j = (i + 3) % 9;
  const Vec3 d = x.segment<3>(i) - x.segment<3>(j);
  const double L = d.blueNorm();
  if (L > 0) {
    F.segment<3>(i) -= k[s] * (L - L0[s]) * (d / L);
    F.segment<3>(j) += k[s] * (L - L0[s]) * (d / L);
  }
  return F;
}

Mat9 massMatrix(const Vec3& m) {
  Mat9 M = Mat9::Identity();
  for (int node = 0; node < 3; ++node) M.middleRows<3>(3 * node) *= m[node];
  return M;
}

double triangleEnergy(const Vec9& x, const Vec3& k, const Vec3& L0) { return energyFrom(0, x, k, L0); }

Vec9 triangleForce(const Vec9& x, const Vec3& k, const Vec3& L0) { return forceFrom(0, x, k, L0); }
