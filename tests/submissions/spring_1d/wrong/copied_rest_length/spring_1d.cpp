// loses: NodeBetween, Oscillator; misconception: argument_twice
// the second line was copied; only L0 was not changed
#include "spring_1d.h"

double lumpedMass(double M, int n) { return M / n; }

double springForceOnA(double xa, double xb, double k, double L0) {
  const double L = std::abs(xa - xb);
  if (L == 0) return 0;
  return -k * (L - L0) * (xa - xb) / L;
}

double springForceOnB(double xa, double xb, double k, double L0) { return springForceOnA(xb, xa, k, L0); }

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  return -g + springForceOnA(x, top.x, top.k, top.L0) / m;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  double a = -g;
  a += springForceOnA(x, lower.x, lower.k, lower.L0) / m;
  a += springForceOnA(x, upper.x, upper.k, lower.L0) / m;
  return a;
}
