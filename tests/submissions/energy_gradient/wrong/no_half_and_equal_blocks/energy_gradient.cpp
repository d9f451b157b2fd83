// loses: EnergyInSpace, EnergyGradient, FiniteDifferences, StretchAndRelease; misconception: missing_half or doubled or same_block_twice
// two mistakes: k (L - L0)^2 in space, and the block of b is that of a
#include "energy_gradient.h"

double springEnergy1d(const Vec2& x, double k, double L0) {
  const double s = std::abs(x[0] - x[1]) - L0;
  return k * s * s / 2;
}

double springEnergy(const Vec6& x, double k, double L0) {
  const double s = (x.head<3>() - x.tail<3>()).norm() - L0;
  return k * s * s;
}

Vec3 lengthGradient(const Vec3& xa, const Vec3& xb) {
  const double L = (xa - xb).norm();
  return L > 0 ? Vec3((xa - xb) / L) : Vec3(0, 0, 0);
}

Vec6 energyGradient(const Vec6& x, double k, double L0) {
  const Vec3 xa = x.head<3>();
  const Vec3 xb = x.tail<3>();
  const double s = (xa - xb).norm() - L0;
  const Vec3 block = k * s * lengthGradient(xa, xb);
  Vec6 gradient;
  gradient << block, block;
  return gradient;
}

Vec6 springForces(const Vec6& x, double k, double L0) { return -energyGradient(x, k, L0); }
