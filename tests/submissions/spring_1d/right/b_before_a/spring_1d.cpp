#include "spring_1d.h"

double lumpedMass(double M, int n) {
  double m = M;
  m /= n;
  return m;
}

double springForceOnB(double xa, double xb, double k, double L0) {
  const double L = std::abs(xb - xa);
  if (L > 0.0) {
    const double u = (xb - xa) / L;  // from a to b
    return -k * (L - L0) * u;
  }
  return 0.0;
}

double springForceOnA(double xa, double xb, double k, double L0) { return -springForceOnB(xa, xb, k, L0); }

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  // the node is b of this call: the spring goes from top to x
  const double F = springForceOnB(top.x, x, top.k, top.L0);
  return F / m - g;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  return hangingAcceleration(x, m, lower, 0.0) + hangingAcceleration(x, m, upper, 0.0) - g;
}
