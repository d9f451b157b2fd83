// loses: Forces, StretchAndRelease; misconception: wrong_node_or_sign or wrong_sign
#include "energy_gradient.h"

double springEnergy1d(const Vec2& x, double k, double L0) {
  const double L = std::abs(x[0] - x[1]);
  return 0.5 * k * (L - L0) * (L - L0);
}

double springEnergy(const Vec6& x, double k, double L0) {
  const double L = (x.head<3>() - x.tail<3>()).norm();
  return 0.5 * k * (L - L0) * (L - L0);
}

Vec3 lengthGradient(const Vec3& xa, const Vec3& xb) {
  const Vec3 r = xa - xb;
  if (r == Vec3::Zero()) return r;
  return r / r.norm();
}

Vec6 energyGradient(const Vec6& x, double k, double L0) {
  const Vec3 r = x.head<3>() - x.tail<3>();
  Vec6 grad;
  grad.head<3>() = k * (r.norm() - L0) * lengthGradient(x.head<3>(), x.tail<3>());
  grad.tail<3>() = -grad.head<3>();
  return grad;
}

Vec6 springForces(const Vec6& x, double k, double L0) { return energyGradient(x, k, L0); }
