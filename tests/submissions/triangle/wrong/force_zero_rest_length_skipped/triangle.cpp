// loses: TriangleForce, MinusTheGradient; misconception: zero_rest_length_skipped
// without rest length it was taken for no spring
#include "triangle.h"

namespace {

struct Link {
  int from;
  int to;
  double stiffness;
  double rest;

  Vec3 vector(const Vec9& x) const { return x.segment<3>(3 * to) - x.segment<3>(3 * from); }
  double extension(const Vec9& x) const { return vector(x).stableNorm() - rest; }
  double energy(const Vec9& x) const {
    const double e = extension(x);
    return 0.5 * stiffness * e * e;
  }
  void addForce(const Vec9& x, Vec9& F) const {
    const Vec3 v = vector(x);
    const double length = v.stableNorm();
    if (length == 0.0 || rest == 0.0) return;
    const Vec3 f = stiffness * extension(x) * (v / length);
    F.segment<3>(3 * from) += f;
    F.segment<3>(3 * to) -= f;
  }
};

std::array<Link, 3> links(const Vec3& k, const Vec3& L0) {
  return {Link{0, 1, k[0], L0[0]}, Link{1, 2, k[1], L0[1]}, Link{2, 0, k[2], L0[2]}};
}

}  // namespace

Mat9 massMatrix(const Vec3& m) {
  Mat9 M = Mat9::Zero();
  M.topLeftCorner<3, 3>() = m[0] * Mat3::Identity();
  M.block<3, 3>(3, 3) = m[1] * Mat3::Identity();
  M.bottomRightCorner<3, 3>() = m[2] * Mat3::Identity();
  return M;
}

double triangleEnergy(const Vec9& x, const Vec3& k, const Vec3& L0) {
  double sum = 0.0;
  for (const Link& link : links(k, L0)) sum += link.energy(x);
  return sum;
}

Vec9 triangleForce(const Vec9& x, const Vec3& k, const Vec3& L0) {
  Vec9 F = Vec9::Zero();
  for (const Link& link : links(k, L0)) link.addForce(x, F);
  return F;
}
