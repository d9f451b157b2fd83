// loses: EnergyInOneDimension, CoincidentNodes, TinyLengths; misconception: none
// "inline makes it faster": the function is not there for the linker
#include "energy_gradient.h"

// The same formula for every number of dimensions.
template <int D>
static double distanceBetween(const Eigen::Matrix<double, 2 * D, 1>& nodes) {
  double d = 0.0;
  for (int c = 0; c < D; ++c) d = std::hypot(d, nodes[c] - nodes[D + c]);
  return d;
}

template <int D>
static double elasticEnergy(const Eigen::Matrix<double, 2 * D, 1>& nodes, double k, double L0) {
  const double u = distanceBetween<D>(nodes) - L0;
  return 0.5 * k * u * u;
}

inline double springEnergy1d(const Vec2& x, double k, double L0) { return elasticEnergy<1>(x, k, L0); }

double springEnergy(const Vec6& x, double k, double L0) { return elasticEnergy<3>(x, k, L0); }

Vec3 lengthGradient(const Vec3& xa, const Vec3& xb) {
  Vec6 nodes;
  nodes << xa, xb;
  const double L = distanceBetween<3>(nodes);
  if (L == 0) return Vec3::Zero();
  Vec3 n = xa - xb;
  n /= L;
  return n;
}

Vec6 energyGradient(const Vec6& x, double k, double L0) {
  const Vec3 n = lengthGradient(x.head<3>(), x.tail<3>());
  const double dEdL = k * (distanceBetween<3>(x) - L0);
  Vec6 g;
  for (int c = 0; c < 3; ++c) {
    g[c] = dEdL * n[c];
    g[c + 3] = -dEdL * n[c];
  }
  return g;
}

Vec6 springForces(const Vec6& x, double k, double L0) { return Vec6::Zero() - energyGradient(x, k, L0); }
