// loses: EnergyGradient, FiniteDifferences, StretchAndRelease; misconception: wrong_node_or_sign or wrong_sign
// pushes where it should pull, in both, each with its own direction
#include "energy_gradient.h"

double springEnergy1d(const Vec2& x, double k, double L0) {
  const double delta = std::abs(x.x() - x.y()) - L0;
  return k * delta * delta * 0.5;
}

double springEnergy(const Vec6& x, double k, double L0) {
  const Vec3 a(x[0], x[1], x[2]), b(x[3], x[4], x[5]);
  const double delta = (b - a).stableNorm() - L0;
  return k * delta * delta * 0.5;
}

Vec3 lengthGradient(const Vec3& xa, const Vec3& xb) {
  const Vec3 v = xa - xb;
  const double L = v.stableNorm();
  return v / (L > 0 ? L : 1.0);  // 0 / 1 where there is no direction
}

Vec6 energyGradient(const Vec6& x, double k, double L0) {
  const Vec3 a(x[0], x[1], x[2]), b(x[3], x[4], x[5]);
  const double delta = (b - a).stableNorm() - L0;
  const Vec3 u = lengthGradient(b, a);
  return (Vec6() << k * delta * u, -(k * delta) * u).finished();
}

Vec6 springForces(const Vec6& x, double k, double L0) {
  const Vec3 a(x[0], x[1], x[2]), b(x[3], x[4], x[5]);
  const double delta = (b - a).stableNorm() - L0;
  const Vec3 u = lengthGradient(a, b);
  return (Vec6() << k * delta * u, -(k * delta) * u).finished();
}
