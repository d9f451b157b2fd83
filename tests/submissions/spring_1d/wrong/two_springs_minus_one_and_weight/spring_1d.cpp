// loses: LumpedMass, HangingNode, NodeBetween, Oscillator; misconception: shared_among_springs or weight_without_mass
// two mistakes
#include "spring_1d.h"

double lumpedMass(double M, int n) { return M / (n - 1.0); }

double springForceOnA(double xa, double xb, double k, double L0) {
  if (xa == xb) return 0.0;
  const double side = xa > xb ? 1.0 : -1.0;
  const double stretch = std::fabs(xa - xb) - L0;
  return -side * k * stretch;
}

double springForceOnB(double xa, double xb, double k, double L0) { return -springForceOnA(xa, xb, k, L0); }

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  return (springForceOnA(x, top.x, top.k, top.L0) - g) / m;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  const double sum = springForceOnA(x, lower.x, lower.k, lower.L0) + springForceOnA(x, upper.x, upper.k, upper.L0);
  return (sum - g) / m;
}
