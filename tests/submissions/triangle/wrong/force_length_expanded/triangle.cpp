// loses: TriangleForce, TinyLengths; misconception: none
// |p - q|^2 = p.p + q.q - 2 p.q: all digits are lost far from the origin
#include "triangle.h"

namespace {

Vec3 gradL(const Vec3& p, const Vec3& q) {
  if (p == q) return Vec3::Zero();
  return (p - q).stableNormalized();
}

double springE(const Vec3& p, const Vec3& q, double k, double L0) {
  return 0.5 * k * std::pow((p - q).stableNorm() - L0, 2);
}

Vec3 gradE(const Vec3& p, const Vec3& q, double k, double L0) {
  const double L2 = p.squaredNorm() + q.squaredNorm() - 2 * p.dot(q);
  if (L2 <= 0) return Vec3::Zero();
  const double L = std::sqrt(L2);
  return k * (L - L0) * (p - q) / L;
}

Vec9 gradientOfTriangle(const Vec9& x, const Vec3& k, const Vec3& L0) {
  const Vec3 x0 = x.segment(0, 3), x1 = x.segment(3, 3), x2 = x.segment(6, 3);
  Vec9 g;
  g << gradE(x0, x1, k[0], L0[0]) + gradE(x0, x2, k[2], L0[2]),
      gradE(x1, x0, k[0], L0[0]) + gradE(x1, x2, k[1], L0[1]),
      gradE(x2, x1, k[1], L0[1]) + gradE(x2, x0, k[2], L0[2]);
  return g;
}

}  // namespace

Mat9 massMatrix(const Vec3& m) {
  Mat9 M = Mat9::Zero();
  for (int i = 0; i < 3; ++i) M.block(3 * i, 3 * i, 3, 3).diagonal().fill(m[i]);
  return M;
}

double triangleEnergy(const Vec9& x, const Vec3& k, const Vec3& L0) {
  const Vec3 x0 = x.segment(0, 3), x1 = x.segment(3, 3), x2 = x.segment(6, 3);
  return springE(x0, x1, k[0], L0[0]) + springE(x1, x2, k[1], L0[1]) + springE(x2, x0, k[2], L0[2]);
}

Vec9 triangleForce(const Vec9& x, const Vec3& k, const Vec3& L0) {
  return -gradientOfTriangle(x, k, L0);
}
