// loses: Forces, CoincidentNodes, TinyLengths, StretchAndRelease; misconception: zero
#include "energy_gradient.h"

double springEnergy1d(const Vec2& x, double k, double L0) {
  const double e = L0 - std::abs(x[0] - x[1]);
  return 0.5 * e * k * e;
}

double springEnergy(const Vec6& x, double k, double L0) {
  const double e = L0 - (x.head<3>() - x.tail<3>()).norm();
  return 0.5 * e * k * e;
}

Vec3 lengthGradient(const Vec3& xa, const Vec3& xb) {
  const double L = (xa - xb).norm();
  if (L <= 0) return Vec3::Zero();
  return (xa - xb) / L;
}

Vec6 energyGradient(const Vec6& x, double k, double L0) {
  // k (L - L0) / L = k (1 - L0 / L)
  const Vec3 r = x.head<3>() - x.tail<3>();
  const double L = r.norm();
  Vec6 g = Vec6::Zero();
  if (L <= 0) return g;
  const double factor = k * (1.0 - L0 / L);
  g.head<3>() = factor * r;
  g.tail<3>() = -factor * r;
  return g;
}

Vec6 springForces(const Vec6& x, double k, double L0) {
  (void)x, (void)k, (void)L0;
  return Vec6::Zero();
}
