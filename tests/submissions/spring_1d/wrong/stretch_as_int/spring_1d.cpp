// loses: HookeForce, CrossedNodes; misconception: whole_numbers
#include "spring_1d.h"

double lumpedMass(double M, int n) { return M / n; }

double springForceOnA(double xa, double xb, double k, double L0) {
  const double L = std::fabs(xa - xb);
  if (L == 0) return 0;
  int stretch = L - L0;
  return -k * stretch * (xa - xb) / L;
}

double springForceOnB(double xa, double xb, double k, double L0) { return -springForceOnA(xa, xb, k, L0); }

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  return springForceOnA(x, top.x, top.k, top.L0) / m - g;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  return (springForceOnA(x, lower.x, lower.k, lower.L0) + springForceOnA(x, upper.x, upper.k, upper.L0)) / m - g;
}
