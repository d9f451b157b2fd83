// loses: ZeroLength; misconception: missing_guard
#include "spring_1d.h"

double lumpedMass(double totalMass, int numNodes) {
  double nodeMass = totalMass / numNodes;
  return nodeMass;
}

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
  return springForceOnA(x, top.x, top.k, top.L0) / m - g;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  const double L1 = std::abs(x - lower.x);
  const double L2 = std::abs(x - upper.x);
  const double F1 = -lower.k * (L1 - lower.L0) * (x - lower.x) / L1;
  const double F2 = -upper.k * (L2 - upper.L0) * (x - upper.x) / L2;
  return (F1 + F2) / m - g;
}
