// loses: EnergyInSpace, FiniteDifferences, CoincidentNodes, StretchAndRelease; misconception: missing_rest_length
#include "energy_gradient.h"

// Divide by the largest component before squaring, so that nothing under- or overflows.
static double safeLength(const Vec3& d) {
  const double biggest = std::max({std::abs(d[0]), std::abs(d[1]), std::abs(d[2])});
  if (biggest == 0.0) return 0.0;
  const double p = d[0] / biggest, q = d[1] / biggest, r = d[2] / biggest;
  return biggest * std::sqrt(p * p + q * q + r * r);
}

static Vec3 safeUnit(const Vec3& d) {
  const double L = safeLength(d);
  if (L == 0.0) return Vec3::Zero();
  return Vec3(d[0] / L, d[1] / L, d[2] / L);
}

double springEnergy1d(const Vec2& x, double k, double L0) {
  const double L = std::max(x[0], x[1]) - std::min(x[0], x[1]);
  return k * (L - L0) * (L - L0) / 2.0;
}

double springEnergy(const Vec6& x, double k, double L0) {
  (void)L0;
  const double L = safeLength(x.head<3>() - x.tail<3>());
  return k * L * L / 2.0;
}

Vec3 lengthGradient(const Vec3& xa, const Vec3& xb) {
  return safeUnit(xa - xb);
}

Vec6 energyGradient(const Vec6& x, double k, double L0) {
  Vec3 xa = x.head<3>();
  Vec3 xb = x.tail<3>();
  double tension = k * (safeLength(xa - xb) - L0);
  Vec6 out = Vec6::Zero();
  out.block<3, 1>(0, 0) = tension * safeUnit(xa - xb);
  out.block<3, 1>(3, 0) = tension * safeUnit(xb - xa);
  return out;
}

Vec6 springForces(const Vec6& x, double k, double L0) {
  Vec3 xa = x.head<3>();
  Vec3 xb = x.tail<3>();
  double tension = k * (safeLength(xa - xb) - L0);
  Vec6 out = Vec6::Zero();
  out.block<3, 1>(0, 0) = tension * safeUnit(xb - xa);
  out.block<3, 1>(3, 0) = tension * safeUnit(xa - xb);
  return out;
}
