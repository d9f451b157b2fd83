// loses: TriangleEnergy; misconception: none
// the square multiplied out: near rest its digits cancel
#include "triangle.h"

namespace {

/// Force on the node at xi of a spring to the node at xj.
Vec3 springForce(const Vec3& xi, const Vec3& xj, double k, double L0) {
  const double L = (xi - xj).norm();
  if (L > 0) return -k * (L - L0) * (xi - xj) / L;
  return Vec3::Zero();
}

}  // namespace

Mat9 massMatrix(const Vec3& m) {
  Mat9 M = Mat9::Zero();
  for (int i = 0; i < 3; ++i) M.block<3, 3>(3 * i, 3 * i) = m[i] * Mat3::Identity();
  return M;
}

double triangleEnergy(const Vec9& x, const Vec3& k, const Vec3& L0) {
  double E = 0.0;
  for (int s = 0; s < 3; ++s) {
    const int i = s;
    const int j = (s + 1) % 3;
    const double L = (x.segment<3>(3 * i) - x.segment<3>(3 * j)).norm();
    E += 0.5 * k[s] * (L * L - 2 * L * L0[s] + L0[s] * L0[s]);
  }
  return E;
}

Vec9 triangleForce(const Vec9& x, const Vec3& k, const Vec3& L0) {
  Vec9 F = Vec9::Zero();
  for (int s = 0; s < 3; ++s) {
    const int i = s;
    const int j = (s + 1) % 3;
    const Vec3 force = springForce(x.segment<3>(3 * i), x.segment<3>(3 * j), k[s], L0[s]);
    F.segment<3>(3 * i) += force;  // += : each node belongs to two springs
    F.segment<3>(3 * j) -= force;
  }
  return F;
}
