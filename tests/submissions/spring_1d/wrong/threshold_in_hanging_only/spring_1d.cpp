// loses: ShortSpring; misconception: threshold
// springForceOnA is right, hangingAcceleration has its own formula that takes L < 1e-6 for zero
#include "spring_1d.h"

double lumpedMass(double M, int n) { return M / n; }

double springForceOnA(double xa, double xb, double k, double L0) {
  double L = std::abs(xa - xb);
  if (L == 0.0) return 0.0;
  double dir = (xa - xb) / L;
  return -k * (L - L0) * dir;
}

double springForceOnB(double xa, double xb, double k, double L0) { return -springForceOnA(xa, xb, k, L0); }


double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  double L = std::abs(x - top.x);
  double F = 0;
  if (L > 1e-6) F = -top.k * (L - top.L0) * (x - top.x) / L;
  return F / m - g;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  double F1 = springForceOnA(x, lower.x, lower.k, lower.L0);
  double F2 = springForceOnA(x, upper.x, upper.k, upper.L0);
  return (F1 + F2 - m * g) / m;
}
