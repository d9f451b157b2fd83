// loses: TriangleForce, MinusTheGradient, FreeFlight; misconception: half_kept or halved
#include "triangle.h"

// r = D x stacks the three differences x0 - x1, x1 - x2, x2 - x0. Then grad E = D^T dE/dr.
static Mat9 incidence() {
  Mat9 D = Mat9::Zero();
  for (int s = 0; s < 3; ++s) {
    D.block<3, 3>(3 * s, 3 * s).setIdentity();
    D.block<3, 3>(3 * s, 3 * ((s + 1) % 3)) = -Mat3::Identity();
  }
  return D;
}

Mat9 massMatrix(const Vec3& m) {
  Mat9 M = Mat9::Zero();
  M.diagonal().segment<3>(0).setConstant(m[0]);
  M.diagonal().segment<3>(3).setConstant(m[1]);
  M.diagonal().segment<3>(6).setConstant(m[2]);
  return M;
}

double triangleEnergy(const Vec9& x, const Vec3& k, const Vec3& L0) {
  const Vec9 r = incidence() * x;
  const Vec3 L(r.segment<3>(0).stableNorm(), r.segment<3>(3).stableNorm(), r.segment<3>(6).stableNorm());
  return 0.5 * (k.array() * (L - L0).array().square()).sum();
}

Vec9 triangleForce(const Vec9& x, const Vec3& k, const Vec3& L0) {
  const Mat9 D = incidence();
  const Vec9 r = D * x;
  Vec9 dEdr;
  for (int s = 0; s < 3; ++s) {
    const Vec3 rs = r.segment<3>(3 * s);
    dEdr.segment<3>(3 * s) = 0.5 * k[s] * (rs.stableNorm() - L0[s]) * rs.stableNormalized();
  }
  return -(D.transpose() * dEdr);
}
