// loses: NodeBetween, Oscillator; misconception: halved
#include "spring_1d.h"

double lumpedMass(double M, int n) {
  // every node gets the same
  return M / (double)n;
}

double springForceOnA(double xa, double xb, double k, double L0) {
  if (xa == xb) return 0.0;
  const double side = xa > xb ? 1.0 : -1.0;
  const double stretch = std::fabs(xa - xb) - L0;
  return -side * k * stretch;
}

double springForceOnB(double xa, double xb, double k, double L0) { return -springForceOnA(xa, xb, k, L0); }

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  double Fs = springForceOnA(x, top.x, top.k, top.L0);
  double Fg = -m * g;
  return (Fs + Fg) / m;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  const double a1 = hangingAcceleration(x, m, lower, g);
  const double a2 = hangingAcceleration(x, m, upper, g);
  return (a1 + a2) / 2;
}
