// loses: LengthGradient; misconception: gradient_of_squared_length
// the energy's gradient has its own unit vector and is right
#include "energy_gradient.h"

double springEnergy1d(const Vec2& x, double k, double L0) {
  const double L = std::abs(x[0] - x[1]);
  return 0.5 * k * (L - L0) * (L - L0);
}

double springEnergy(const Vec6& x, double k, double L0) {
  const Vec3 r = x.head<3>() - x.tail<3>();
  const double s = r.norm() - L0;
  return 0.5 * k * s * s;
}

Vec3 lengthGradient(const Vec3& xa, const Vec3& xb) {
  return 2 * (xa - xb);  // from L^2 = (xa - xb)^T (xa - xb)
}

Vec6 energyGradient(const Vec6& x, double k, double L0) {
  const Vec3 r = x.head<3>() - x.tail<3>();
  const double L = r.norm();
  Vec6 g = Vec6::Zero();
  if (L > 0) {
    g.head<3>() = k * (L - L0) * (r / L);
    g.tail<3>() = -g.head<3>();
  }
  return g;
}

Vec6 springForces(const Vec6& x, double k, double L0) { return -energyGradient(x, k, L0); }
