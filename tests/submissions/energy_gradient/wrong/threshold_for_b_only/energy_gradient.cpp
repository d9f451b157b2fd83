// loses: TinyLengths; misconception: threshold
// the block of a compares with 0, that of b with a number
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
  const Vec3 r = x.head<3>() - x.tail<3>();
  const double L = r.norm();
  Vec6 g = Vec6::Zero();
  if (L != 0) g.head<3>() = k * (L - L0) * r / L;
  if (L > 1e-30) g.tail<3>() = -k * (L - L0) * r / L;
  return g;
}

Vec6 springForces(const Vec6& x, double k, double L0) { return -energyGradient(x, k, L0); }
