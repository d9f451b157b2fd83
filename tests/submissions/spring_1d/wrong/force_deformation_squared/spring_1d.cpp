// loses: HookeForce, CrossedNodes; misconception: deformation_squared
#include "spring_1d.h"

double lumpedMass(double M, int n) { return M / n; }

double springForceOnA(double xa, double xb, double k, double L0) {
  double L = std::abs(xa - xb);
  if (L == 0) return 0;
  return -k * std::pow(L - L0, 2) * (xa - xb) / L;
}

double springForceOnB(double xa, double xb, double k, double L0) { return -springForceOnA(xa, xb, k, L0); }

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  double Fs = springForceOnA(x, top.x, top.k, top.L0);
  double Fg = -m * g;
  return (Fs + Fg) / m;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  const double f = springForceOnA(x, lower.x, lower.k, lower.L0) + springForceOnA(x, upper.x, upper.k, upper.L0);
  return f / m - g;
}
