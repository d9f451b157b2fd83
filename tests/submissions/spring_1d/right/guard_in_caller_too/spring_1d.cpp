#include "spring_1d.h"

// Formula written out for every function.

double lumpedMass(double M, int n) { return M / n; }

double springForceOnA(double xa, double xb, double k, double L0) {
  double L = fabs(xa - xb);
  if (L != 0.0) return -k * (L - L0) * (xa - xb) / L;
  return 0.0;
}

double springForceOnB(double xa, double xb, double k, double L0) {
  double L = fabs(xa - xb);
  if (L != 0.0) return k * (L - L0) * (xa - xb) / L;
  return 0.0;
}

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  double L = fabs(x - top.x);
  if (L == 0.0) return -g;
  double force = -top.k * (L - top.L0) * (x - top.x) / L - m * g;
  return force / m;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  double a = -g;
  double L1 = fabs(x - lower.x);
  if (L1 != 0.0) a -= lower.k / m * (L1 - lower.L0) * (x - lower.x) / L1;
  double L2 = fabs(x - upper.x);
  if (L2 != 0.0) a -= upper.k / m * (L2 - upper.L0) * (x - upper.x) / L2;
  return a;
}
