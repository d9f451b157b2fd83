// loses: HookeForce, CrossedNodes, ShortSpring; misconception: softened_length
#include "spring_1d.h"

double lumpedMass(double totalMass, int numNodes) {
  double nodeMass = totalMass / numNodes;
  return nodeMass;
}

double springForceOnA(double xa, double xb, double k, double L0) {
  const double tiny = 1e-3;
  double d = xa - xb;
  double L = std::abs(d);
  return -k * (L - L0) * d / (L + tiny);
}

double springForceOnB(double xa, double xb, double k, double L0) {
  double onA = springForceOnA(xa, xb, k, L0);
  return -onA;
}

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  double force = springForceOnA(x, top.x, top.k, top.L0);
  force -= m * g;
  return force / m;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  double Fl = springForceOnA(x, lower.x, lower.k, lower.L0);
  double Fu = springForceOnA(x, upper.x, upper.k, upper.L0);
  double Fg = -m * g;
  return (Fl + Fu + Fg) / m;
}
