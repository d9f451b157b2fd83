// loses: ThirdLaw, ZeroLength, ShortSpring; misconception: zero
#include "spring_1d.h"

double lumpedMass(double M, int n) {
  // every node gets the same
  return M / (double)n;
}

double springForceOnA(double xa, double xb, double k, double L0) {
  const double L = std::abs(xa - xb);
  if (L == 0.0) return 0.0;
  return -k * (L - L0) * (xa - xb) / L;
}

double springForceOnB(double xa, double xb, double k, double L0) {
  (void)xa, (void)xb, (void)k, (void)L0;
  return 0.0;
}

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  double Fs = springForceOnA(x, top.x, top.k, top.L0);
  double Fg = -m * g;
  return (Fs + Fg) / m;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  double Fl = springForceOnA(x, lower.x, lower.k, lower.L0);
  double Fu = springForceOnA(x, upper.x, upper.k, upper.L0);
  double Fg = -m * g;
  return (Fl + Fu + Fg) / m;
}
