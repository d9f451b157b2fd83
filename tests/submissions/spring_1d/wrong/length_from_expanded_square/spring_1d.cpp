// loses: ShortSpring; misconception: threshold
// (xa - xb)^2 multiplied out: near each other and far from the origin only a few digits are left, or none
#include "spring_1d.h"

double lumpedMass(double M, int n) { return M / n; }

static double lengthOf(double xa, double xb) {
  const double square = xa * xa - 2 * xa * xb + xb * xb;
  return square > 0 ? std::sqrt(square) : 0.0;
}

double springForceOnA(double xa, double xb, double k, double L0) {
  const double L = lengthOf(xa, xb);
  if (L == 0) return 0;
  return -k * (L - L0) * (xa - xb) / L;
}

double springForceOnB(double xa, double xb, double k, double L0) { return -springForceOnA(xa, xb, k, L0); }

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  return springForceOnA(x, top.x, top.k, top.L0) / m - g;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  return (springForceOnA(x, lower.x, lower.k, lower.L0) + springForceOnA(x, upper.x, upper.k, upper.L0)) / m - g;
}
