#include "energy_gradient.h"

double springEnergy1d(const Vec2& x, double k, double L0) {
  const double stretch = x[0] > x[1] ? x[0] - x[1] - L0 : x[1] - x[0] - L0;
  return k / 2 * stretch * stretch;
}

double springEnergy(const Vec6& x, double k, double L0) {
  const double stretch = std::hypot(x[0] - x[3], x[1] - x[4], x[2] - x[5]) - L0;
  return k / 2 * std::pow(stretch, 2);
}

Vec3 lengthGradient(const Vec3& xa, const Vec3& xb) {
  const double L = std::hypot(xa.x() - xb.x(), xa.y() - xb.y(), xa.z() - xb.z());
  Vec3 gradient;
  for (int i = 0; i < 3; ++i) gradient[i] = L > 0 ? (xa[i] - xb[i]) / L : 0.0;
  return gradient;
}

Vec6 energyGradient(const Vec6& x, double k, double L0) {
  const double L = std::hypot(x[0] - x[3], x[1] - x[4], x[2] - x[5]);
  Vec6 gradient = Vec6::Zero();
  if (L > 0) {
    for (int i = 0; i < 3; ++i) {
      gradient[i] = k * (L - L0) * ((x[i] - x[i + 3]) / L);
      gradient[i + 3] = k * (L - L0) * ((x[i + 3] - x[i]) / L);
    }
  }
  return gradient;
}

Vec6 springForces(const Vec6& x, double k, double L0) {
  const Vec6 gradient = energyGradient(x, k, L0);
  return Vec6::Zero() - gradient;
}
