// loses: ZeroLength; misconception: force_at_zero_length
// thought: copysign saves me from 0/0
#include "spring_1d.h"

double lumpedMass(double M, int n) {
  // every node gets the same
  return M / (double)n;
}

double springForceOnA(double xa, double xb, double k, double L0) {
  const double d = xa - xb;
  const double e = std::copysign(1.0, d);
  return -k * (std::abs(d) - L0) * e;
}

double springForceOnB(double xa, double xb, double k, double L0) { return -springForceOnA(xa, xb, k, L0); }

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  double Fs = springForceOnA(x, top.x, top.k, top.L0);
  double Fg = -m * g;
  return (Fs + Fg) / m;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  double force = 0.0;
  for (const Attachment& s : {lower, upper}) {
    force += springForceOnA(x, s.x, s.k, s.L0);
  }
  return force / m - g;
}
