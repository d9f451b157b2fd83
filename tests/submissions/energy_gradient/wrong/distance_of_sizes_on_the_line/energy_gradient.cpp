// loses: EnergyInOneDimension; misconception: absolute_coordinates
// right as long as both nodes are on one side of the origin
#include "energy_gradient.h"

double springEnergy1d(const Vec2& x, double k, double L0) {
  const double L = std::abs(std::abs(x[0]) - std::abs(x[1]));
  return 0.5 * k * (L - L0) * (L - L0);
}

double springEnergy(const Vec6& x, double k, double L0) {
  const double L = (x.head<3>() - x.tail<3>()).norm();
  return 0.5 * k * (L - L0) * (L - L0);
}

Vec3 lengthGradient(const Vec3& xa, const Vec3& xb) {
  const Vec3 r = xa - xb;
  const double L = r.norm();
  if (L > 0) return r / L;
  return Vec3::Zero();
}

Vec6 energyGradient(const Vec6& x, double k, double L0) {
  const Vec3 xa = x.head<3>(), xb = x.tail<3>();
  const Vec3 u = lengthGradient(xa, xb);
  const double f = k * ((xa - xb).norm() - L0);
  Vec6 g;
  g << f * u, -f * u;
  return g;
}

Vec6 springForces(const Vec6& x, double k, double L0) { return energyGradient(x, -k, L0); }
