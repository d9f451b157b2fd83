#include "spring_1d.h"

double lumpedMass(double M, int n) { return static_cast<double>(static_cast<long double>(M) / n); }

static long double hooke(long double a, long double b, long double k, long double rest) {
  const long double delta = a - b;
  if (delta == 0.0L) return 0.0L;
  const long double len = delta < 0 ? -delta : delta;
  return -k * (len - rest) * (delta / len);
}

double springForceOnA(double xa, double xb, double k, double L0) { return double(hooke(xa, xb, k, L0)); }
double springForceOnB(double xa, double xb, double k, double L0) { return double(hooke(xb, xa, k, L0)); }

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  return double(hooke(x, top.x, top.k, top.L0) / m - g);
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  const long double f = hooke(x, lower.x, lower.k, lower.L0) + hooke(x, upper.x, upper.k, upper.L0);
  return double(f / m - g);
}
