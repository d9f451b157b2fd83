#include "spring_1d.h"

/// -1, 0 or +1. At L = 0 it is 0 and takes care of the special case by itself.
template <typename T>
static int signum(T value) {
  return (T(0) < value) - (value < T(0));
}

double lumpedMass(double M, int n) { return M / n; }

double springForceOnA(double xa, double xb, double k, double L0) {
  const double dx = xa - xb;
  return -k * (std::abs(dx) - L0) * signum(dx);
}

double springForceOnB(double xa, double xb, double k, double L0) {
  const double dx = xb - xa;
  return -k * (std::abs(dx) - L0) * signum(dx);
}

template <typename... Springs>
static double acceleration(double x, double m, double g, const Springs&... s) {
  const double total = (springForceOnA(x, s.x, s.k, s.L0) + ...);
  return total / m - g;
}

double hangingAcceleration(double x, double m, const Attachment& top, double g) { return acceleration(x, m, g, top); }

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  return acceleration(x, m, g, lower, upper);
}
