// loses: HookeForce, CrossedNodes; misconception: edge
// thought: L0 = 0 is an unset spring
#include "spring_1d.h"

double lumpedMass(double M, int n) { return M / n; }

double springForceOnA(double xa, double xb, double k, double L0) {
  if (L0 == 0.0) return 0.0;
  const double L = std::abs(xa - xb);
  if (L == 0.0) return 0.0;
  return -k * (L - L0) * (xa - xb) / L;
}

double springForceOnB(double xa, double xb, double k, double L0) {
  // third law
  return -springForceOnA(xa, xb, k, L0);
}

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  return springForceOnA(x, top.x, top.k, top.L0) / m - g;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  const double f = springForceOnA(x, lower.x, lower.k, lower.L0) + springForceOnA(x, upper.x, upper.k, upper.L0);
  return f / m - g;
}
