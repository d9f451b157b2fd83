// loses: NodeBetween, Oscillator; misconception: never_written
#include "spring_1d.h"

double lumpedMass(double M, int n) { return M / n; }

double springForceOnA(double xa, double xb, double k, double L0) {
  double delta = xb - xa;
  double length = std::abs(delta);
  if (!(length > 0)) return 0;
  return k * (length - L0) * (delta / length);
}

double springForceOnB(double xa, double xb, double k, double L0) { return -springForceOnA(xa, xb, k, L0); }

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  double force = springForceOnA(x, top.x, top.k, top.L0);
  force -= m * g;
  return force / m;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  double force;
  force += springForceOnA(x, lower.x, lower.k, lower.L0);
  force += springForceOnA(x, upper.x, upper.k, upper.L0);
  return force / m - g;
}
