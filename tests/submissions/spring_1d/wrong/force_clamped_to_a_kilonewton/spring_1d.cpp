// loses: HookeForce, CrossedNodes; misconception: none
// thought: huge forces make the simulation explode
#include "spring_1d.h"

double lumpedMass(double M, int n) {
  // every node gets the same
  return M / (double)n;
}

double springForceOnA(double xa, double xb, double k, double L0) {
  const double L = std::abs(xa - xb);
  if (L == 0.0) return 0.0;
  const double f = -k * (L - L0) * (xa - xb) / L;
  return std::clamp(f, -1000.0, 1000.0);
}

double springForceOnB(double xa, double xb, double k, double L0) { return -springForceOnA(xa, xb, k, L0); }

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  double force = springForceOnA(x, top.x, top.k, top.L0);
  force -= m * g;
  return force / m;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  const double f = springForceOnA(x, lower.x, lower.k, lower.L0) + springForceOnA(x, upper.x, upper.k, upper.L0);
  return f / m - g;
}
