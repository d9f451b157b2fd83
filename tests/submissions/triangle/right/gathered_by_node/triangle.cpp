#include "triangle.h"

// Each node gathers the forces of its two springs: spring i goes on to the next node, spring i + 2 comes from the one
// before.
namespace {
Vec3 node(const Vec9& x, int i) { return x.segment<3>(3 * (i % 3)); }

Vec3 lengthGradient(const Vec3& xa, const Vec3& xb) {
  const double L = (xa - xb).norm();
  return L > 0.0 ? Vec3((xa - xb) / L) : Vec3(Vec3::Zero());
}
}  // namespace

Mat9 massMatrix(const Vec3& m) {
  Mat9 M = Mat9::Identity();
  for (int i = 0; i < 3; ++i) M.middleRows<3>(3 * i) *= m[i];
  return M;
}

double triangleEnergy(const Vec9& x, const Vec3& k, const Vec3& L0) {
  Vec3 L;
  for (int i = 0; i < 3; ++i) L[i] = (node(x, i) - node(x, i + 1)).norm();
  return 0.5 * (k.array() * (L - L0).array().square()).sum();
}

Vec9 triangleForce(const Vec9& x, const Vec3& k, const Vec3& L0) {
  Vec9 gradient;
  for (int i = 0; i < 3; ++i) {
    const int before = (i + 2) % 3;
    const double toNext = (node(x, i) - node(x, i + 1)).norm();
    const double toBefore = (node(x, i) - node(x, before)).norm();
    gradient.segment<3>(3 * i) = k[i] * (toNext - L0[i]) * lengthGradient(node(x, i), node(x, i + 1)) +
                                 k[before] * (toBefore - L0[before]) * lengthGradient(node(x, i), node(x, before));
  }
  return -gradient;
}
