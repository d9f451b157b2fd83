// loses: CrossedNodes; misconception: signed_length
// b calls a with the nodes exchanged, which the signed length does not stand
#include "spring_1d.h"

double lumpedMass(double totalMass, int numNodes) {
  double nodeMass = totalMass / numNodes;
  return nodeMass;
}

double springForceOnA(double xa, double xb, double k, double L0) {
  double L = xa - xb;
  if (L == 0) return 0;
  return -k * (L - L0);
}

double springForceOnB(double xa, double xb, double k, double L0) {
  return springForceOnA(xb, xa, k, L0);
}

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  double force = springForceOnA(x, top.x, top.k, top.L0);
  force -= m * g;
  return force / m;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  const double f = springForceOnA(x, lower.x, lower.k, lower.L0) + springForceOnA(x, upper.x, upper.k, upper.L0);
  return f / m - g;
}
