// loses: HangingNode; misconception: none
// thought: avoid dividing by a tiny mass
#include "spring_1d.h"

double lumpedMass(double M, int n) { return M / n; }

double springForceOnA(double xa, double xb, double k, double L0) {
  double delta = xb - xa;
  double length = std::abs(delta);
  if (!(length > 0)) return 0;
  return k * (length - L0) * (delta / length);
}

double springForceOnB(double xa, double xb, double k, double L0) {
  // third law
  return -springForceOnA(xa, xb, k, L0);
}

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  if (m < 1e-3) return -g;
  return springForceOnA(x, top.x, top.k, top.L0) / m - g;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  double Fl = springForceOnA(x, lower.x, lower.k, lower.L0);
  double Fu = springForceOnA(x, upper.x, upper.k, upper.L0);
  double Fg = -m * g;
  return (Fl + Fu + Fg) / m;
}
