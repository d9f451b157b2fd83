#include "triangle.h"

namespace {

constexpr int ends[3][2] = {{0, 1}, {1, 2}, {2, 0}};

Vec3 node(const Vec9& x, int i) { return x.segment<3>(3 * i); }

}  // namespace

Mat9 massMatrix(const Vec3& m) {
  Vec9 diagonal;
  diagonal << m[0], m[0], m[0], m[1], m[1], m[1], m[2], m[2], m[2];
  return diagonal.asDiagonal();
}

double triangleEnergy(const Vec9& x, const Vec3& k, const Vec3& L0) {
  double twice = 0;
  for (int s = 0; s < 3; ++s) {
    const double stretch = (node(x, ends[s][0]) - node(x, ends[s][1])).norm() - L0[s];
    twice += k[s] * stretch * stretch;
  }
  return twice / 2;
}

Vec9 triangleForce(const Vec9& x, const Vec3& k, const Vec3& L0) {
  Vec9 force = Vec9::Zero();
  for (int s = 0; s < 3; ++s) {
    const int i = ends[s][0], j = ends[s][1];
    const Vec3 r = node(x, j) - node(x, i);
    const double L = r.norm();
    if (L == 0) continue;
    const Vec3 pull = k[s] * (L - L0[s]) * (r / L);
    force.segment<3>(3 * i) += pull;
    force.segment<3>(3 * j) -= pull;
  }
  return force;
}
