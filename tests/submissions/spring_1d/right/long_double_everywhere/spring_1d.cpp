#include "spring_1d.h"

namespace {
using real = long double;

real hooke(real xa, real xb, real k, real L0) {
  const real gap = xa - xb;
  if (gap > 0) return k * (L0 - gap);
  if (gap < 0) return -k * (L0 + gap);
  return 0;
}
}  // namespace

double lumpedMass(double M, int n) { return static_cast<double>(static_cast<real>(M) / n); }

double springForceOnA(double xa, double xb, double k, double L0) { return static_cast<double>(hooke(xa, xb, k, L0)); }

double springForceOnB(double xa, double xb, double k, double L0) { return static_cast<double>(-hooke(xa, xb, k, L0)); }

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  const real weight = static_cast<real>(m) * g;
  return static_cast<double>((hooke(x, top.x, top.k, top.L0) - weight) / m);
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  const real sum = hooke(x, lower.x, lower.k, lower.L0) + hooke(x, upper.x, upper.k, upper.L0);
  return static_cast<double>((sum - static_cast<real>(m) * g) / m);
}
