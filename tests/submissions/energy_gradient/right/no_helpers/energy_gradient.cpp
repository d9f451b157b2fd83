#include "energy_gradient.h"

// Everything written out by components.

double springEnergy1d(const Vec2& x, double k, double L0) {
  double L = x(0) - x(1);
  if (L < 0) L = -L;
  return k * std::pow(L - L0, 2) / 2;
}

double springEnergy(const Vec6& x, double k, double L0) {
  double sum = 0;
  for (int i = 0; i < 3; i++) sum += (x(i + 3) - x(i)) * (x(i + 3) - x(i));
  return k * std::pow(std::sqrt(sum) - L0, 2) / 2;
}

Vec3 lengthGradient(const Vec3& xa, const Vec3& xb) {
  Vec3 g(0, 0, 0);
  double L = std::sqrt((xa - xb).dot(xa - xb));
  if (L == 0) return g;
  for (int i = 0; i < 3; i++) g(i) = (xa(i) - xb(i)) / L;
  return g;
}

Vec6 energyGradient(const Vec6& x, double k, double L0) {
  Vec6 g;
  double sum = 0;
  for (int i = 0; i < 3; i++) sum += (x(i + 3) - x(i)) * (x(i + 3) - x(i));
  double L = std::sqrt(sum);
  for (int i = 0; i < 6; i++) g(i) = 0;
  if (L == 0) return g;
  for (int i = 0; i < 3; i++) {
    g(i) = k * (L - L0) * (x(i) - x(i + 3)) / L;
    g(i + 3) = k * (L - L0) * (x(i + 3) - x(i)) / L;
  }
  return g;
}

Vec6 springForces(const Vec6& x, double k, double L0) {
  Vec6 F = energyGradient(x, k, L0);
  for (int i = 0; i < 6; i++) F(i) = -F(i);
  return F;
}
