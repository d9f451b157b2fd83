// loses: EnergyInSpace, FiniteDifferences, StretchAndRelease; misconception: squared_length
#include "energy_gradient.h"

double springEnergy1d(const Vec2& x, double k, double L0) {
  const double L = std::abs(x[0] - x[1]);
  const double s = L - L0;
  return 0.5 * k * s * s;
}

double springEnergy(const Vec6& x, double k, double L0) {
  double L = 0;
  for (int i = 0; i < 3; ++i) L += (x[i] - x[i + 3]) * (x[i] - x[i + 3]);
  return 0.5 * k * (L - L0) * (L - L0);
}

Vec3 lengthGradient(const Vec3& xa, const Vec3& xb) {
  const double L = (xa - xb).norm();
  if (L == 0) return Vec3::Zero();
  return (xa - xb) / L;
}

Vec6 energyGradient(const Vec6& x, double k, double L0) {
  const Vec3 xa = x.head<3>(), xb = x.tail<3>();
  const double L = (xa - xb).norm();
  Vec6 g;
  g.head<3>() = k * (L - L0) * lengthGradient(xa, xb);
  g.tail<3>() = k * (L - L0) * lengthGradient(xb, xa);
  return g;
}

Vec6 springForces(const Vec6& x, double k, double L0) { return -energyGradient(x, k, L0); }
