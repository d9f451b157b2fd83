// loses: LumpedMass; misconception: stateful or constant
// "all nodes have the same mass, so compute it only once"
#include "spring_1d.h"

double lumpedMass(double M, int n) {
  static const double mass = M / n;
  return mass;
}

double springForceOnA(double xa, double xb, double k, double L0) {
  const double L = std::abs(xa - xb);
  if (L == 0) return 0;
  return k * (L0 - L) * (xa - xb) / L;
}

double springForceOnB(double xa, double xb, double k, double L0) {
  const double L = std::abs(xa - xb);
  if (L == 0) return 0;
  return k * (L0 - L) * (xb - xa) / L;
}

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  const auto& [xt, k, L0] = top;
  return springForceOnA(x, xt, k, L0) / m - g;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  const auto& [x1, k1, l1] = lower;
  const auto& [x2, k2, l2] = upper;
  return (springForceOnA(x, x1, k1, l1) + springForceOnA(x, x2, k2, l2)) / m - g;
}
