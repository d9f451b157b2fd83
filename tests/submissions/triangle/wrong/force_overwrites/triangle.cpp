// loses: TriangleForce, MinusTheGradient, NewtonsThirdLaw, Equivariance, CoincidentNodes, FreeFlight; misconception: overwrites
#include "triangle.h"

#include <numeric>

static std::vector<Vec3> nodesOf(const Vec9& x) {
  std::vector<Vec3> nodes;
  for (int i = 0; i < 3; ++i) nodes.push_back(x.segment<3>(3 * i));
  return nodes;
}

static double dist(const Vec3& p, const Vec3& q) { return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]); }

Mat9 massMatrix(const Vec3& m) {
  std::vector<double> diagonal;
  for (double mass : {m[0], m[1], m[2]}) diagonal.insert(diagonal.end(), 3, mass);
  return Eigen::Map<Vec9>(diagonal.data()).asDiagonal();
}

double triangleEnergy(const Vec9& x, const Vec3& k, const Vec3& L0) {
  const std::vector<Vec3> n = nodesOf(x);
  std::vector<double> energies;
  for (int s = 0; s < 3; ++s) {
    const double L = dist(n[s], n[(s + 1) % 3]);
    energies.push_back(0.5 * k[s] * (L - L0[s]) * (L - L0[s]));
  }
  return std::accumulate(energies.begin(), energies.end(), 0.0);
}

Vec9 triangleForce(const Vec9& x, const Vec3& k, const Vec3& L0) {
  const std::vector<Vec3> n = nodesOf(x);
  std::vector<Vec3> f(3, Vec3::Zero());
  for (int s = 0; s < 3; ++s) {
    const int t = (s + 1) % 3;
    const double L = dist(n[s], n[t]);
    if (L > 0) {
      const Vec3 dir = (n[t] - n[s]) / L;
      f[s] = k[s] * (L - L0[s]) * dir;
      f[t] = -k[s] * (L - L0[s]) * dir;
    }
  }
  Vec9 F;
  F << f[0], f[1], f[2];
  return F;
}
