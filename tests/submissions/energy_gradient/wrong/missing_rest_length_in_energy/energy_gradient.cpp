// loses: EnergyInOneDimension, EnergyInSpace, FiniteDifferences, CoincidentNodes, StretchAndRelease; misconception: missing_rest_length
#include "energy_gradient.h"

double springEnergy1d(const Vec2& x, double k, double) {
  const double L = std::abs(x[0] - x[1]);
  return 0.5 * k * L * L;
}

double springEnergy(const Vec6& x, double k, double) {
  const Vec3 xa = x.head<3>();
  const Vec3 xb = x.tail<3>();
  const double L = (xa - xb).norm();
  return 0.5 * k * L * L;
}

Vec3 lengthGradient(const Vec3& xa, const Vec3& xb) {
  const double L = (xa - xb).norm();
  if (L > 0) return (xa - xb) / L;
  return Vec3::Zero();
}

Vec6 energyGradient(const Vec6& x, double k, double L0) {
  const Vec3 xa = x.head<3>();
  const Vec3 xb = x.tail<3>();
  const double L = (xa - xb).norm();
  // E depends on both nodes: each block is the derivative with respect to its own node.
  Vec6 gradient;
  gradient.head<3>() = k * (L - L0) * lengthGradient(xa, xb);
  gradient.tail<3>() = k * (L - L0) * lengthGradient(xb, xa);
  return gradient;
}

Vec6 springForces(const Vec6& x, double k, double L0) { return -energyGradient(x, k, L0); }
