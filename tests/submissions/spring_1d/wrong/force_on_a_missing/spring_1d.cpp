// loses: HookeForce, CrossedNodes, ThirdLaw, ZeroLength, ShortSpring, HangingNode, NodeBetween, Oscillator; misconception: ignored or zero
#include "spring_1d.h"

double lumpedMass(double M, int n) {
  return M / static_cast<double>(n);
}

double springForceOnA(double xa, double xb, double k, double L0) {
  double F = -k * (fabs(xa - xb) - L0);
  // TODO direction
  F = 0;
  return F;
}

double springForceOnB(double xa, double xb, double k, double L0) { return -springForceOnA(xa, xb, k, L0); }

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  return springForceOnA(x, top.x, top.k, top.L0) / m - g;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  const double f = springForceOnA(x, lower.x, lower.k, lower.L0) + springForceOnA(x, upper.x, upper.k, upper.L0);
  return f / m - g;
}
