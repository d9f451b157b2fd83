// loses: EnergyInSpace; misconception: none
// k/2 (L^2 - 2 L L0 + L0^2): equal in algebra, but near the rest length the digits cancel
#include "energy_gradient.h"

double springEnergy1d(const Vec2& x, double k, double L0) {
  const double s = std::abs(x[0] - x[1]) - L0;
  return 0.5 * k * s * s;
}

double springEnergy(const Vec6& x, double k, double L0) {
  const Vec3 r = x.head<3>() - x.tail<3>();
  return 0.5 * k * (r.dot(r) - 2.0 * r.norm() * L0 + L0 * L0);
}

Vec3 lengthGradient(const Vec3& xa, const Vec3& xb) {
  const double L = (xa - xb).norm();
  if (L == 0) return Vec3::Zero();
  return (xa - xb) / L;
}

Vec6 energyGradient(const Vec6& x, double k, double L0) {
  const Vec3 xa = x.head<3>(), xb = x.tail<3>();
  const Vec3 onA = k * ((xa - xb).norm() - L0) * lengthGradient(xa, xb);
  Vec6 g;
  g << onA, -onA;
  return g;
}

Vec6 springForces(const Vec6& x, double k, double L0) { return -energyGradient(x, k, L0); }
