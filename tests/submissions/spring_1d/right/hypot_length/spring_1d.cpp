#include "spring_1d.h"

double lumpedMass(double totalMass, int nodes) { return totalMass / nodes; }

double springForceOnA(double xa, double xb, double k, double L0) {
  double L = std::hypot(xa - xb, 0.0);
  if (!(L > 0.0)) return 0.0;
  double magnitude = -k * (L - L0);
  double direction = (xa - xb) / L;
  return magnitude * direction;
}

double springForceOnB(double xa, double xb, double k, double L0) { return -1.0 * springForceOnA(xa, xb, k, L0); }

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  double F = 0.0;
  F += springForceOnA(x, top.x, top.k, top.L0);
  F -= m * g;
  return F / m;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  double F1 = springForceOnA(x, lower.x, lower.k, lower.L0);
  double F2 = springForceOnB(upper.x, x, upper.k, upper.L0);
  return (F1 + F2) / m - g;
}
