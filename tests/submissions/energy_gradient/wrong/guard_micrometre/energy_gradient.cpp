// loses: TinyLengths; misconception: threshold
// below 1 um the direction is noise
#include "energy_gradient.h"

double springEnergy1d(const Vec2& x, double k, double L0) {
  return k / 2.0 * std::pow(std::abs(x[1] - x[0]) - L0, 2);
}

double springEnergy(const Vec6& x, double k, double L0) {
  return k / 2.0 * std::pow((x.head<3>() - x.tail<3>()).stableNorm() - L0, 2);
}

// Eigen hands a zero vector back as it is, so no guard is needed here.
Vec3 lengthGradient(const Vec3& xa, const Vec3& xb) {
  if ((xa - xb).norm() < 1e-6) return Vec3::Zero();
  return (xa - xb).stableNormalized();
}

Vec6 energyGradient(const Vec6& x, double k, double L0) {
  const Vec3 r = x.head<3>() - x.tail<3>();
  const Vec3 ga = k * (r.stableNorm() - L0) * r.stableNormalized();
  Vec6 g;
  g << ga, -ga;
  return g;
}

Vec6 springForces(const Vec6& x, double k, double L0) {
  return energyGradient(x, k, L0) * -1.0;
}
