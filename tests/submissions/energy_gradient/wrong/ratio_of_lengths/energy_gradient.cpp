// loses: EnergyInOneDimension, EnergyInSpace, EnergyGradient, FiniteDifferences, CoincidentNodes; misconception: missing_guard or edge
// the stretch in parts of L0: no number for L0 = 0, which is allowed
#include "energy_gradient.h"


double springEnergy1d(const Vec2& x, double k, double L0) {
  double r = std::abs(x[0] - x[1]) / L0;
  return 0.5 * k * L0 * L0 * (r - 1) * (r - 1);
}


double springEnergy(const Vec6& x, double k, double L0) {
  double r = (x.head<3>() - x.tail<3>()).norm() / L0;
  return 0.5 * k * L0 * L0 * (r - 1) * (r - 1);
}

Vec3 lengthGradient(const Vec3& xa, const Vec3& xb) {
  double L = (xa - xb).norm();
  if (L == 0.0) return Vec3::Zero();
  return (xa - xb) / L;
}


Vec6 energyGradient(const Vec6& x, double k, double L0) {
  Vec3 xa = x.head<3>(), xb = x.tail<3>();
  Vec3 ga = k * L0 * ((xa - xb).norm() / L0 - 1) * lengthGradient(xa, xb);
  Vec6 g;
  g << ga, -ga;
  return g;
}

Vec6 springForces(const Vec6& x, double k, double L0) { return -energyGradient(x, k, L0); }
