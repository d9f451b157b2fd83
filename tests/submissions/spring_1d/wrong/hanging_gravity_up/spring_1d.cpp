// loses: HangingNode, Oscillator; misconception: gravity_up
#include "spring_1d.h"

double lumpedMass(double M, int n) { return M / n; }

double springForceOnA(double xa, double xb, double k, double L0) {
  double diff = xa - xb;
  double len = fabs(diff);
  if (len == 0) {
    return 0;
  }
  double dir = diff / len;
  double mag = -k * (len - L0);
  return mag * dir;
}

double springForceOnB(double xa, double xb, double k, double L0) { return -springForceOnA(xa, xb, k, L0); }

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  double F = springForceOnA(x, top.x, top.k, top.L0) + m * g;
  return F / m;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  const double f = springForceOnA(x, lower.x, lower.k, lower.L0) + springForceOnA(x, upper.x, upper.k, upper.L0);
  return f / m - g;
}
