// loses: HangingNode, NodeBetween, Oscillator; misconception: gravity_up
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
  double onA = springForceOnA(xa, xb, k, L0);
  return -onA;
}

namespace {
double newton(double force, double m, double g) { return force / m + g; }
}  // namespace

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  return newton(springForceOnA(x, top.x, top.k, top.L0), m, g);
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  return newton(springForceOnA(x, lower.x, lower.k, lower.L0) + springForceOnA(x, upper.x, upper.k, upper.L0), m, g);
}
