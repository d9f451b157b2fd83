// loses: HookeForce, CrossedNodes, ShortSpring; misconception: difference_quotient or threshold
// thought: force is minus the slope of the energy
#include "spring_1d.h"

double lumpedMass(double M, int n) { return M / n; }

static double energy(double xa, double xb, double k, double L0) {
  const double e = std::abs(xa - xb) - L0;
  return k * e * e / 2;
}

double springForceOnA(double xa, double xb, double k, double L0) {
  if (xa == xb) return 0.0;
  const double h = 1e-6;
  return -(energy(xa + h, xb, k, L0) - energy(xa, xb, k, L0)) / h;
}

double springForceOnB(double xa, double xb, double k, double L0) { return -springForceOnA(xa, xb, k, L0); }

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  return springForceOnA(x, top.x, top.k, top.L0) / m - g;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  double Fl = springForceOnA(x, lower.x, lower.k, lower.L0);
  double Fu = springForceOnA(x, upper.x, upper.k, upper.L0);
  double Fg = -m * g;
  return (Fl + Fu + Fg) / m;
}
