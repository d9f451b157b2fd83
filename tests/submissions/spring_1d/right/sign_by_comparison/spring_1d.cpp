#include "spring_1d.h"

double lumpedMass(double M, int n) { return M / static_cast<double>(n); }

double springForceOnA(double xa, double xb, double k, double L0) {
  if (xa == xb) {
    return 0.0;  // no direction
  }
  const double length = std::fabs(xa - xb);
  const double sign = xa > xb ? 1.0 : -1.0;
  return sign * k * (L0 - length);
}

double springForceOnB(double xa, double xb, double k, double L0) {
  const double onA = springForceOnA(xa, xb, k, L0);
  return onA == 0.0 ? 0.0 : -onA;
}

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  const double spring = springForceOnA(x, top.x, top.k, top.L0);
  const double weight = m * g;
  return (spring - weight) / m;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  double sum = -m * g;
  sum += springForceOnA(x, lower.x, lower.k, lower.L0);
  sum += springForceOnA(x, upper.x, upper.k, upper.L0);
  return sum / m;
}
