#include "spring_1d.h"

#include <cmath>

// The lecture's formula written out in each function, with the direction as a number of its own.

double lumpedMass(double M, int n) { return M / static_cast<double>(n); }

double springForceOnA(double xa, double xb, double k, double L0) {
  double d = xa - xb;
  double L = std::sqrt(d * d);
  if (d != 0) L = std::fabs(d);  // the square of a very short length underflows
  double direction = 0;
  if (L > 0) direction = d / L;
  return -k * (L - L0) * direction;
}

double springForceOnB(double xa, double xb, double k, double L0) {
  double d = xb - xa;
  double L = std::fabs(d);
  double direction = L > 0 ? d / L : 0.0;
  return -k * (L - L0) * direction;
}

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  double Fspring = springForceOnB(top.x, x, top.k, top.L0);
  double Fgravity = -m * g;
  return (Fspring + Fgravity) / m;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  double F = 0;
  F += springForceOnA(x, lower.x, lower.k, lower.L0);
  F += springForceOnA(x, upper.x, upper.k, upper.L0);
  F -= m * g;
  return F / m;
}
