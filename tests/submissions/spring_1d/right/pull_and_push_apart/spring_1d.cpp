#include "spring_1d.h"

double lumpedMass(double M, int n) { return std::divides<double>{}(M, n); }

double springForceOnA(double xa, double xb, double k, double L0) {
  const double d = xa - xb;
  const double L = std::abs(d);
  const double stretched = std::max(L - L0, 0.0);
  const double squeezed = std::max(L0 - L, 0.0);
  if (d > 0) return k * squeezed - k * stretched;
  if (d < 0) return k * stretched - k * squeezed;
  return 0.0;
}

double springForceOnB(double xa, double xb, double k, double L0) { return -springForceOnA(xa, xb, k, L0); }

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  const double inverseMass = 1.0 / m;
  return inverseMass * springForceOnA(x, top.x, top.k, top.L0) - g;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  const double inverseMass = 1.0 / m;
  const double fromAbove = springForceOnA(x, upper.x, upper.k, upper.L0);
  const double fromBelow = springForceOnA(x, lower.x, lower.k, lower.L0);
  return inverseMass * (fromAbove + fromBelow) - g;
}
