// loses: EnergyGradient, FiniteDifferences, CoincidentNodes; misconception: none
// counts from 1 to 3 for a, so b is read from component 2 on; the energy is right
#include "energy_gradient.h"

double springEnergy1d(const Vec2& x, double k, double L0) {
  const double L = std::abs(x[0] - x[1]);
  return 0.5 * k * (L - L0) * (L - L0);
}

double springEnergy(const Vec6& x, double k, double L0) {
  const double L = (x.head<3>() - x.tail<3>()).norm();
  return 0.5 * k * (L - L0) * (L - L0);
}

Vec3 lengthGradient(const Vec3& xa, const Vec3& xb) {
  const double L = (xa - xb).norm();
  if (L == 0) return Vec3::Zero();
  return (xa - xb) / L;
}

Vec6 energyGradient(const Vec6& x, double k, double L0) {
  const Vec3 xa = x.segment<3>(0);
  const Vec3 xb = x.segment<3>(2);
  const double L = (xa - xb).norm();
  Vec6 g = Vec6::Zero();
  g.segment<3>(0) = k * (L - L0) * lengthGradient(xa, xb);
  g.segment<3>(3) = k * (L - L0) * lengthGradient(xb, xa);
  return g;
}

Vec6 springForces(const Vec6& x, double k, double L0) { return -energyGradient(x, k, L0); }
