// loses: HangingNode, ZeroLength, Oscillator; misconception: signed_length or missing_direction or one_sided
// thought: a hanging node is below
#include "spring_1d.h"

double lumpedMass(double M, int n) { return M / n; }

double springForceOnA(double xa, double xb, double k, double L0) {
  const double L = std::abs(xa - xb);
  if (L == 0.0) return 0.0;
  return -k * (L - L0) * (xa - xb) / L;
}

double springForceOnB(double xa, double xb, double k, double L0) {
  // third law
  return -springForceOnA(xa, xb, k, L0);
}

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  const double elongation = (top.x - x) - top.L0;
  return top.k * elongation / m - g;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  const double f = springForceOnA(x, lower.x, lower.k, lower.L0) + springForceOnA(x, upper.x, upper.k, upper.L0);
  return f / m - g;
}
