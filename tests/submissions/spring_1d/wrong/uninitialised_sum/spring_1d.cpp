// loses: NodeBetween, Oscillator; misconception: never_written
// adds to an uninitialised variable
#include "spring_1d.h"

double lumpedMass(double M, int n) { return M / n; }

double springForceOnA(double xa, double xb, double k, double L0) {
  double L = std::abs(xa - xb);
  if (L == 0.0) return 0.0;
  double dir = (xa - xb) / L;
  return -k * (L - L0) * dir;
}

double springForceOnB(double xa, double xb, double k, double L0) { return -springForceOnA(xa, xb, k, L0); }

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  double F = springForceOnA(x, top.x, top.k, top.L0);
  return (F - m * g) / m;
}


double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  double F;
  F += springForceOnA(x, lower.x, lower.k, lower.L0);
  F += springForceOnA(x, upper.x, upper.k, upper.L0);
  return F / m - g;
}
