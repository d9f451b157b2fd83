#include "spring_1d.h"

// Written by cases instead of the lecture's quotient: a is above b, below b, or on it.

namespace oracle {

double lumpedMass(double M, int n) { return M * (1.0 / n); }

double springForceOnA(double xa, double xb, double k, double L0) {
  if (xa > xb) return k * (L0 - (xa - xb));
  if (xa < xb) return k * ((xb - xa) - L0);
  return 0.0;
}

double springForceOnB(double xa, double xb, double k, double L0) { return -given::springForceOnA(xa, xb, k, L0); }

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  return (given::springForceOnA(x, top.x, top.k, top.L0) - m * g) / m;
}

// Not by given::hangingAcceleration: who writes the weight anew has its mistakes anew.
double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  const double below = given::springForceOnA(x, lower.x, lower.k, lower.L0);
  return (below + given::springForceOnA(x, upper.x, upper.k, upper.L0)) / m - g;
}

}  // namespace oracle
