// loses: EnergyGradient, FiniteDifferences; misconception: half_kept
#include "energy_gradient.h"

double springEnergy1d(const Vec2& x, double k, double L0) {
  double L = std::fabs(x[0] - x[1]);
  return 0.5 * k * pow(L - L0, 2);
}

double springEnergy(const Vec6& x, double k, double L0) {
  Vec3 xa(x[0], x[1], x[2]);
  Vec3 xb(x[3], x[4], x[5]);
  double L = (xa - xb).norm();
  return 0.5 * k * pow(L - L0, 2);
}

Vec3 lengthGradient(const Vec3& xa, const Vec3& xb) {
  double L = (xa - xb).norm();
  if (L == 0) return Vec3(0, 0, 0);
  return (xa - xb) / L;
}

Vec6 energyGradient(const Vec6& x, double k, double L0) {
  Vec3 xa(x[0], x[1], x[2]);
  Vec3 xb(x[3], x[4], x[5]);
  double L = (xa - xb).norm();
  Vec3 ga = 0.5 * k * (L - L0) * lengthGradient(xa, xb);
  Vec3 gb = 0.5 * k * (L - L0) * lengthGradient(xb, xa);
  Vec6 g;
  g << ga, gb;
  return g;
}

Vec6 springForces(const Vec6& x, double k, double L0) {
  Vec6 g = energyGradient(x, k, L0);
  return -g;
}
