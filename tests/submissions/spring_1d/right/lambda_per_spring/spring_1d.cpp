#include "spring_1d.h"

double lumpedMass(double M, int n) { return M / n; }

double springForceOnA(double xa, double xb, double k, double L0) {
  auto length = [&] { return std::abs(xa - xb); };
  auto direction = [&] { return (xa - xb) / length(); };
  if (length() == 0.0) return 0.0;
  return -k * (length() - L0) * direction();
}

double springForceOnB(double xa, double xb, double k, double L0) { return -springForceOnA(xa, xb, k, L0); }

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  auto force = [x](const Attachment& s) { return springForceOnA(x, s.x, s.k, s.L0); };
  return force(top) / m - g;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  auto force = [x](const Attachment& s) { return springForceOnA(x, s.x, s.k, s.L0); };
  return (force(upper) + force(lower)) / m - g;
}
