// loses: NodeBetween, Oscillator; misconception: squared or factor_too_many or argument_twice
// the forces are divided by m one by one, and their sum again; right for m = 1 kg
#include "spring_1d.h"

double lumpedMass(double M, int n) { return M / n; }

double springForceOnA(double xa, double xb, double k, double L0) {
  double L = std::abs(xa - xb);
  double F = 0;
  if (L != 0) F = -k * (L - L0) * (xa - xb) / L;
  return F;
}

double springForceOnB(double xa, double xb, double k, double L0) {
  double F = springForceOnA(xa, xb, k, L0);
  return -F;
}

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  return springForceOnA(x, top.x, top.k, top.L0) / m - g;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  double below = springForceOnA(x, lower.x, lower.k, lower.L0) / m;
  double above = springForceOnA(x, upper.x, upper.k, upper.L0) / m;
  return (below + above) / m - g;
}
