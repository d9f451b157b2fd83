// loses: LumpedMass, HangingNode, Oscillator; misconception: shared_among_springs or missing_mass
// two mistakes: n - 1 pieces of the chain, and the hanging node's sum of forces is not divided by m
#include "spring_1d.h"

double lumpedMass(double M, int n) {
  return M / (n - 1);
}

double springForceOnA(double xa, double xb, double k, double L0) {
  const double L = std::fabs(xa - xb);
  if (L > 0) {
    return -k * (L - L0) * ((xa - xb) / L);
  }
  return 0.0;
}

double springForceOnB(double xa, double xb, double k, double L0) {
  const double L = std::fabs(xb - xa);
  if (L > 0) {
    return -k * (L - L0) * ((xb - xa) / L);
  }
  return 0.0;
}

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  double total = springForceOnA(x, top.x, top.k, top.L0);
  total -= m * g;
  return total;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  double total = springForceOnA(x, lower.x, lower.k, lower.L0);
  total += springForceOnA(x, upper.x, upper.k, upper.L0);
  total -= m * g;
  return total / m;
}
