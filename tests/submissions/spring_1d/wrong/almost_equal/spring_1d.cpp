// loses: ShortSpring; misconception: threshold
// takes positions that agree in 1e-12 of their size for equal
#include "spring_1d.h"

double lumpedMass(double M, int n) { return M / n; }


static bool almostEqual(double a, double b) {
  return std::abs(a - b) <= 1e-12 * std::max(std::abs(a), std::abs(b));
}
double springForceOnA(double xa, double xb, double k, double L0) {
  if (almostEqual(xa, xb)) return 0;
  double L = std::abs(xa - xb);
  return -k * (L - L0) * (xa - xb) / L;
}

double springForceOnB(double xa, double xb, double k, double L0) { return -springForceOnA(xa, xb, k, L0); }

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  double F = springForceOnA(x, top.x, top.k, top.L0);
  return (F - m * g) / m;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  double F1 = springForceOnA(x, lower.x, lower.k, lower.L0);
  double F2 = springForceOnA(x, upper.x, upper.k, upper.L0);
  return (F1 + F2 - m * g) / m;
}
