// loses: LumpedMass; misconception: integer_division or zero
#include "spring_1d.h"

double lumpedMass(double M, int n) {
  double fraction = 1 / n;  // each node's share of the object
  return fraction * M;
}

double springForceOnA(double xa, double xb, double k, double L0) {
  double r = xa - xb;
  double L = std::sqrt(r * r);
  if (L == 0.0) return 0.0;
  return -k * (L - L0) * r / L;
}

double springForceOnB(double xa, double xb, double k, double L0) { return springForceOnA(xb, xa, k, L0); }

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  return (springForceOnA(x, top.x, top.k, top.L0) - m * g) / m;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  return (springForceOnA(x, lower.x, lower.k, lower.L0) + springForceOnA(x, upper.x, upper.k, upper.L0) - m * g) / m;
}
