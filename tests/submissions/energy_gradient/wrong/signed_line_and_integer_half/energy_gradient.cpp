// loses: EnergyInOneDimension, EnergyInSpace, FiniteDifferences, CoincidentNodes, TinyLengths, StretchAndRelease; misconception: signed_length or integer_division or zero
// two mistakes: the length on the line has a sign, and 1 / 2 in space
#include "energy_gradient.h"

double springEnergy1d(const Vec2& x, double k, double L0) {
  double L = x[0] - x[1];
  return 0.5 * k * (L - L0) * (L - L0);
}

double springEnergy(const Vec6& x, double k, double L0) {
  Vec3 a = x.head<3>(), b = x.tail<3>();
  double L = (a - b).norm();
  return (1 / 2) * k * (L - L0) * (L - L0);
}

Vec3 lengthGradient(const Vec3& xa, const Vec3& xb) {
  double L = (xa - xb).norm();
  if (L == 0) return Vec3::Zero();
  return (xa - xb) / L;
}

Vec6 energyGradient(const Vec6& x, double k, double L0) {
  Vec3 a = x.head<3>(), b = x.tail<3>();
  double L = (a - b).norm();
  Vec6 g;
  g.head<3>() = k * (L - L0) * lengthGradient(a, b);
  g.tail<3>() = -g.head<3>();
  return g;
}

Vec6 springForces(const Vec6& x, double k, double L0) { return -energyGradient(x, k, L0); }
