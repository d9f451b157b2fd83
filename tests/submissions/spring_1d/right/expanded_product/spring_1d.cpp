#include "spring_1d.h"

// The product is expanded, k L - k L0: where these are large, it is rounded otherwise than k (L - L0).

namespace {

double pull(double from, double to, double k, double L0) {
  if (to > from) return k * (to - from) - k * L0;
  if (to < from) return k * L0 - k * (from - to);
  return 0.0;
}

}  // namespace

double lumpedMass(double M, int n) { return M / n; }

double springForceOnA(double xa, double xb, double k, double L0) { return pull(xa, xb, k, L0); }

double springForceOnB(double xa, double xb, double k, double L0) { return pull(xb, xa, k, L0); }

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  return pull(x, top.x, top.k, top.L0) / m - g;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  return (pull(x, lower.x, lower.k, lower.L0) + pull(x, upper.x, upper.k, upper.L0)) / m - g;
}
