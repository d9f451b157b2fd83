// loses: EnergyInOneDimension, CoincidentNodes, TinyLengths; misconception: zero
// forgot the 1D function; 3D has a formula of its own
#include "energy_gradient.h"

double springEnergy1d(const Vec2& x, double k, double L0) {
  (void)x, (void)k, (void)L0;  // delete this line once you use them
  return 0.0;
}

double springEnergy(const Vec6& x, double k, double L0) {
  const double distance = (x.head<3>() - x.tail<3>()).stableNorm();
  return 0.5 * k * (distance - L0) * (distance - L0);
}

Vec3 lengthGradient(const Vec3& xa, const Vec3& xb) {
  if (xa == xb) return Vec3::Zero();
  return (xa - xb).stableNormalized();
}

Vec6 energyGradient(const Vec6& x, double k, double L0) {
  const Eigen::Matrix<double, 3, 2> nodes = Eigen::Map<const Eigen::Matrix<double, 3, 2>>(x.data());
  const Vec3 n = lengthGradient(nodes.col(0), nodes.col(1));
  const double stretch = (nodes.col(0) - nodes.col(1)).stableNorm() - L0;
  Vec6 g;
  for (int node = 0; node < 2; ++node) {
    const double sign = node == 0 ? 1.0 : -1.0;
    g.segment<3>(3 * node) = sign * k * stretch * n;
  }
  return g;
}

Vec6 springForces(const Vec6& x, double k, double L0) { return -energyGradient(x, k, L0); }
