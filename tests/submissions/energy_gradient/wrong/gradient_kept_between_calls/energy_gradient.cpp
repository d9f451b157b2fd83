// loses: EnergyGradient, FiniteDifferences, Forces, CoincidentNodes, TinyLengths, StretchAndRelease; misconception: stateful
#include "energy_gradient.h"

double springEnergy1d(const Vec2& x, double k, double L0) {
  const double s = std::abs(x[0] - x[1]) - L0;
  return 0.5 * k * s * s;
}

double springEnergy(const Vec6& x, double k, double L0) {
  const double s = (x.head<3>() - x.tail<3>()).norm() - L0;
  return 0.5 * k * s * s;
}

Vec3 lengthGradient(const Vec3& xa, const Vec3& xb) {
  const double L = (xa - xb).norm();
  if (L == 0) return Vec3::Zero();
  return (xa - xb) / L;
}

Vec6 energyGradient(const Vec6& x, double k, double L0) {
  static Vec6 g = Vec6::Zero();
  const Vec3 xa = x.head<3>(), xb = x.tail<3>();
  const double dE = k * ((xa - xb).norm() - L0);
  g.head<3>() += dE * lengthGradient(xa, xb);
  g.tail<3>() += dE * lengthGradient(xb, xa);
  return g;
}

Vec6 springForces(const Vec6& x, double k, double L0) { return -energyGradient(x, k, L0); }
