#include "spring_1d.h"

// Where a would be at rest is b +- L0, on the side where a is now. The force pulls it there.

double lumpedMass(double M, int n) {
  const double share = 1.0 / n;
  return share * M;
}

double springForceOnA(double xa, double xb, double k, double L0) {
  const double r = xa - xb;
  return r == 0 ? 0 : k * (std::copysign(L0, r) - r);
}

double springForceOnB(double xa, double xb, double k, double L0) { return springForceOnA(xb, xa, k, L0); }

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  return -g + springForceOnA(x, top.x, top.k, top.L0) / m;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  return -g + springForceOnA(x, lower.x, lower.k, lower.L0) / m + springForceOnA(x, upper.x, upper.k, upper.L0) / m;
}
