// loses: Forces; misconception: zero_rest_length_ignored or edge
// "a spring without rest length is no spring": only the forces, and only for L0 = 0
#include "energy_gradient.h"

double springEnergy1d(const Vec2& x, double k, double L0) {
  const double s = std::abs(x[0] - x[1]) - L0;
  return 0.5 * k * s * s;
}

double springEnergy(const Vec6& x, double k, double L0) {
  const double s = (x.head<3>() - x.tail<3>()).norm() - L0;
  return 0.5 * k * s * s;
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

Vec6 springForces(const Vec6& x, double k, double L0) {
  if (L0 == 0.0) return Vec6::Zero();
  return -energyGradient(x, k, L0);
}
