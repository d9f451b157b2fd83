// loses: HookeForce, CrossedNodes, ZeroLength; misconception: none
// two mistakes
#include "spring_1d.h"

double lumpedMass(double totalMass, int numNodes) {
  double nodeMass = totalMass / numNodes;
  return nodeMass;
}

double springForceOnA(double xa, double xb, double k, double L0) {
  const double L = std::abs(xa - xb);
  const double u = (xa - xb) / L;
  return k * (L - L0) * u;
}

double springForceOnB(double xa, double xb, double k, double L0) { return -springForceOnA(xa, xb, k, L0); }

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  double force = springForceOnA(x, top.x, top.k, top.L0);
  force -= m * g;
  return force / m;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  double force = 0.0;
  for (const Attachment& s : {lower, upper}) {
    force += springForceOnA(x, s.x, s.k, s.L0);
  }
  return force / m - g;
}
