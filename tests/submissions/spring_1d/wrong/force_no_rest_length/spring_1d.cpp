// loses: HookeForce, CrossedNodes; misconception: missing_rest_length
#include "spring_1d.h"

double lumpedMass(double totalMass, int numNodes) {
  double nodeMass = totalMass / numNodes;
  return nodeMass;
}

double springForceOnA(double xa, double xb, double k, double L0) {
  (void)L0;
  return -k * (xa - xb);
}

double springForceOnB(double xa, double xb, double k, double L0) {
  // third law
  return -springForceOnA(xa, xb, k, L0);
}

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  double Fs = springForceOnA(x, top.x, top.k, top.L0);
  double Fg = -m * g;
  return (Fs + Fg) / m;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  double Fl = springForceOnA(x, lower.x, lower.k, lower.L0);
  double Fu = springForceOnA(x, upper.x, upper.k, upper.L0);
  double Fg = -m * g;
  return (Fl + Fu + Fg) / m;
}
