// loses: EnergyGradient, TinyLengths; misconception: difference_quotient or threshold
// as in the section on checking
#include "energy_gradient.h"

namespace {
// extended precision: squares of small numbers do not vanish
long double length(const double* a, const double* b) {
  long double sum = 0.0L;
  for (int i = 0; i < 3; i++) {
    const long double d = static_cast<long double>(a[i]) - b[i];
    sum += d * d;
  }
  return std::sqrt(sum);
}
}  // namespace

double springEnergy1d(const Vec2& x, double k, double L0) {
  long double L = static_cast<long double>(x[0]) - x[1];
  if (L < 0) L = -L;
  return static_cast<double>(0.5L * k * (L - L0) * (L - L0));
}

double springEnergy(const Vec6& x, double k, double L0) {
  const long double L = length(x.data(), x.data() + 3);
  return static_cast<double>(0.5L * k * (L - L0) * (L - L0));
}

Vec3 lengthGradient(const Vec3& xa, const Vec3& xb) {
  const long double L = length(xa.data(), xb.data());
  Vec3 grad = Vec3::Zero();
  if (L > 0.0L) {
    for (int i = 0; i < 3; i++) grad[i] = static_cast<double>((static_cast<long double>(xa[i]) - xb[i]) / L);
  }
  return grad;
}

Vec6 energyGradient(const Vec6& x, double k, double L0) {
  const double h = 1e-5;
  Vec6 grad;
  for (int i = 0; i < 6; i++) {
    Vec6 more = x, less = x;
    more[i] += h;
    less[i] -= h;
    grad[i] = (springEnergy(more, k, L0) - springEnergy(less, k, L0)) / (2 * h);
  }
  return grad;
}

Vec6 springForces(const Vec6& x, double k, double L0) {
  return -1 * energyGradient(x, k, L0);
}
