// loses: NodeBetween, Oscillator; misconception: same_spring_twice
#include "spring_1d.h"

double lumpedMass(double totalMass, int numNodes) {
  double nodeMass = totalMass / numNodes;
  return nodeMass;
}

double springForceOnA(double xa, double xb, double k, double L0) {
  double delta = xb - xa;
  double length = std::abs(delta);
  if (!(length > 0)) return 0;
  return k * (length - L0) * (delta / length);
}

double springForceOnB(double xa, double xb, double k, double L0) { return -springForceOnA(xa, xb, k, L0); }

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  return springForceOnA(x, top.x, top.k, top.L0) / m - g;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  (void)upper;
  double F1 = springForceOnA(x, lower.x, lower.k, lower.L0);
  double F2 = springForceOnA(x, lower.x, lower.k, lower.L0);
  return (F1 + F2) / m - g;
}
