// loses: EnergyInSpace, TinyLengths; misconception: none
// |a - b|^2 = a.a + b.b - 2 a.b: all digits are lost far from the origin
#include "energy_gradient.h"

// E = (sqrt(k/2) (L - L0))^2 : the energy is one square.

double springEnergy1d(const Vec2& x, double k, double L0) {
  const double c = std::sqrt(k / 2) * (std::abs(x[0] - x[1]) - L0);
  return c * c;
}

double springEnergy(const Vec6& x, double k, double L0) {
  const Vec3 a = x.head<3>(), b = x.tail<3>();
  const double L2 = a.dot(a) + b.dot(b) - 2 * a.dot(b);
  const double c = std::sqrt(k / 2) * (std::sqrt(std::max(L2, 0.0)) - L0);
  return c * c;
}

Vec3 lengthGradient(const Vec3& xa, const Vec3& xb) {
  Vec3 n = Vec3::Zero();
  const double L = (xa - xb).blueNorm();
  if (L > 0) n = (xa - xb) / L;
  return n;
}

Vec6 energyGradient(const Vec6& x, double k, double L0) {
  const auto xa = x.head<3>();
  const auto xb = x.tail<3>();
  const double L = (xa - xb).blueNorm();
  // grad c^2 = 2 c grad c
  const double c = std::sqrt(k / 2) * (L - L0);
  const double twoCdC = 2 * c * std::sqrt(k / 2);
  Vec6 g;
  g.head<3>() = twoCdC * lengthGradient(xa, xb);
  g.tail<3>() = -g.head<3>();
  return g;
}

Vec6 springForces(const Vec6& x, double k, double L0) {
  const Vec6 downhill = -energyGradient(x, k, L0);
  return downhill;
}
