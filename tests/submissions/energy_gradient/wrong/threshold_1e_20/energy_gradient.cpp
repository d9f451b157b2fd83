// loses: TinyLengths; misconception: threshold
#include "energy_gradient.h"

double springEnergy1d(const Vec2& x, double k, double L0) {
  double L = std::abs(x[0] - x[1]);
  return 0.5 * k * (L - L0) * (L - L0);
}

double springEnergy(const Vec6& x, double k, double L0) {
  Vec3 xa = x.head<3>(), xb = x.tail<3>();
  double L = (xa - xb).norm();
  return 0.5 * k * (L - L0) * (L - L0);
}


Vec3 lengthGradient(const Vec3& xa, const Vec3& xb) {
  double L = (xa - xb).norm();
  if (L < 1e-20) return Vec3::Zero();
  return (xa - xb) / L;
}

Vec6 energyGradient(const Vec6& x, double k, double L0) {
  Vec3 xa = x.head<3>(), xb = x.tail<3>();
  double L = (xa - xb).norm();
  Vec3 ga = k * (L - L0) * lengthGradient(xa, xb);
  Vec6 g;
  g << ga, -ga;
  return g;
}

Vec6 springForces(const Vec6& x, double k, double L0) { return -energyGradient(x, k, L0); }
