// loses: ThirdLaw; misconception: wrong_sign
// exchanges the nodes and adds a minus as well
#include "spring_1d.h"

double lumpedMass(double M, int n) { return M / n; }

double springForceOnA(double xa, double xb, double k, double L0) {
  if (xa == xb) return 0;
  const double length = std::abs(xa - xb);
  const double up = xa > xb ? 1.0 : -1.0;
  return -k * (length - L0) * up;
}

double springForceOnB(double xa, double xb, double k, double L0) {
  return -springForceOnA(xb, xa, k, L0);  // the opposite, seen from b
}

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  const double F = springForceOnA(x, top.x, top.k, top.L0);
  return F / m - g;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  const double F = springForceOnA(x, lower.x, lower.k, lower.L0) + springForceOnA(x, upper.x, upper.k, upper.L0);
  return F / m - g;
}
