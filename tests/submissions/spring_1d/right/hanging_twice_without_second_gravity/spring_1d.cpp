#include "spring_1d.h"

double lumpedMass(const double M, const int n) { return M / n; }

double springForceOnA(double xa, double xb, double k, double L0) {
  const double L = std::sqrt((xa - xb) * (xa - xb));
  const double safe = L > 1e-120 ? L : std::abs(xa - xb);  // the square underflows before the length does
  if (safe == 0.0) return 0.0;
  return -k * (safe - L0) * ((xa - xb) / safe);
}

double springForceOnB(double xa, double xb, double k, double L0) { return -springForceOnA(xa, xb, k, L0); }

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  return springForceOnA(x, top.x, top.k, top.L0) / m - g;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  return hangingAcceleration(x, m, lower, 0) + hangingAcceleration(x, m, upper, g);
}
