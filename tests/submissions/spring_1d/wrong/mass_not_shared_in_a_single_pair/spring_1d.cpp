// loses: LumpedMass; misconception: none
// thought: with up to two nodes there is one spring, no chain, so nothing to share
#include "spring_1d.h"

double lumpedMass(double M, int n) {
  if (n <= 2) return M;
  return M / n;
}

double springForceOnA(double xa, double xb, double k, double L0) {
  const double L = std::abs(xa - xb);
  if (L == 0.0) return 0.0;
  return -k * (L - L0) * (xa - xb) / L;
}

double springForceOnB(double xa, double xb, double k, double L0) { return -springForceOnA(xa, xb, k, L0); }

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  double force = springForceOnA(x, top.x, top.k, top.L0);
  force -= m * g;
  return force / m;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  double Fl = springForceOnA(x, lower.x, lower.k, lower.L0);
  double Fu = springForceOnA(x, upper.x, upper.k, upper.L0);
  double Fg = -m * g;
  return (Fl + Fu + Fg) / m;
}
