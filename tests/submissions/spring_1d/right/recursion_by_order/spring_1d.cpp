#include "spring_1d.h"

double lumpedMass(double M, int n) {
  const double share = 1.0 / n;
  return M * share;
}

double springForceOnA(double xa, double xb, double k, double L0) {
  if (xa == xb) return 0.0;
  if (xa < xb) return -springForceOnA(xb, xa, k, L0);  // turn the picture round so that a is above
  const double length = xa - xb;
  return k * (L0 - length);
}

double springForceOnB(double xa, double xb, double k, double L0) {
  if (xa == xb) return 0.0;
  return -springForceOnA(xa, xb, k, L0);
}

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  auto pull = [x](const Attachment& s) { return springForceOnA(x, s.x, s.k, s.L0); };
  return (pull(top) - m * g) / m;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  // the hanging node of before, plus what the second spring adds
  return hangingAcceleration(x, m, lower, g) + hangingAcceleration(x, m, upper, 0.0);
}
