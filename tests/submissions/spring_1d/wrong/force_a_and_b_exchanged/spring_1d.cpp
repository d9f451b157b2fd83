// loses: HookeForce, CrossedNodes; misconception: wrong_sign or swapped_arguments
// thought: the force on a is the one that a exerts; the rest is right because it uses "B"
#include "spring_1d.h"

double lumpedMass(double M, int n) { return M / n; }

double springForceOnB(double xa, double xb, double k, double L0) {
  const double r = xa - xb;
  const double L = std::abs(r);
  return L == 0.0 ? 0.0 : -k * (L - L0) * (r / L);
}

double springForceOnA(double xa, double xb, double k, double L0) { return -springForceOnB(xa, xb, k, L0); }

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  return springForceOnB(x, top.x, top.k, top.L0) / m - g;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  return (springForceOnB(x, lower.x, lower.k, lower.L0) + springForceOnB(x, upper.x, upper.k, upper.L0)) / m - g;
}
