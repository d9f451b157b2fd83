// loses: TriangleEnergy, MinusTheGradient, Equivariance, CoincidentNodes, TinyLengths, FreeFlight; misconception: integer_division or zero
// 1 / 2 is 0
#include "triangle.h"

namespace {

Vec3 node(const Vec9& x, int i) { return x.segment<3>(3 * (i % 3)); }

// pull on the node at `here` towards the node at `there`
Vec3 pull(const Vec3& here, const Vec3& there, double k, double L0) {
  const double L = (there - here).stableNorm();
  if (L == 0) return Vec3::Zero();
  return k * (L - L0) * ((there - here) / L);
}

}  // namespace

Mat9 massMatrix(const Vec3& m) {
  Mat9 M;
  for (int r = 0; r < 9; ++r)
    for (int c = 0; c < 9; ++c) M(r, c) = r == c ? m[r / 3] : 0.0;
  return M;
}

double triangleEnergy(const Vec9& x, const Vec3& k, const Vec3& L0) {
  double E = 0;
  for (int i = 0; i < 3; ++i) {
    const double u = (node(x, i) - node(x, i + 1)).stableNorm() - L0[i];
    E += 1 / 2 * k[i] * u * u;
  }
  return E;
}

Vec9 triangleForce(const Vec9& x, const Vec3& k, const Vec3& L0) {
  // Every node has a spring that starts there and one that ends there.
  Vec9 F;
  for (int i = 0; i < 3; ++i) {
    const int before = (i + 2) % 3;
    F.segment<3>(3 * i) = pull(node(x, i), node(x, i + 1), k[i], L0[i]) +
                          pull(node(x, i), node(x, before), k[before], L0[before]);
  }
  return F;
}
