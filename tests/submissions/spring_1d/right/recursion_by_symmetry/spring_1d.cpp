#include "spring_1d.h"

double lumpedMass(double M, int n) { return (M / n); }

double springForceOnA(double xa, double xb, double k, double L0) {
  // Only the case "a above b" has to be thought about; the other one is its mirror image.
  if (xa < xb) return -springForceOnA(xb, xa, k, L0);
  const double L = xa - xb;
  if (L == 0) return 0;
  return k * (L0 - L);
}

double springForceOnB(double xa, double xb, double k, double L0) { return springForceOnA(xb, xa, k, L0); }

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  const auto [xt, k, L0] = top;
  return springForceOnA(x, xt, k, L0) / m - g;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  const auto [xl, kl, Ll] = lower;
  const auto [xu, ku, Lu] = upper;
  return (springForceOnA(x, xl, kl, Ll) + springForceOnA(x, xu, ku, Lu)) / m - g;
}
