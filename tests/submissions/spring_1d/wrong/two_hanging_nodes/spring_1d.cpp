// loses: NodeBetween, Oscillator; misconception: gravity_twice
#include "spring_1d.h"

double lumpedMass(double M, int n) { return M / n; }

double springForceOnA(double xa, double xb, double k, double L0) {
  const double L = std::abs(xa - xb);
  if (!(L > 0)) return 0;
  const double direction = (xa - xb) / L, magnitude = -k * (L - L0);
  return magnitude * direction;
}

double springForceOnB(double xa, double xb, double k, double L0) {
  const double onA = springForceOnA(xa, xb, k, L0);
  return -onA;
}

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  return springForceOnA(x, top.x, top.k, top.L0) / m - g;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  // both springs hold the node, so add both
  return hangingAcceleration(x, m, lower, g) + hangingAcceleration(x, m, upper, g);
}
