// loses: HookeForce, CrossedNodes, ThirdLaw, HangingNode, NodeBetween, Oscillator; misconception: stateful
#include "spring_1d.h"

double lumpedMass(double M, int n) {
  return M / static_cast<double>(n);
}

double springForceOnA(double xa, double xb, double k, double L0) {
  static double stiffness = 0.0;
  if (stiffness == 0.0) stiffness = k;
  const double L = std::abs(xa - xb);
  if (L == 0.0) return 0.0;
  return -stiffness * (L - L0) * (xa - xb) / L;
}

double springForceOnB(double xa, double xb, double k, double L0) { return -springForceOnA(xa, xb, k, L0); }

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  double Fs = springForceOnA(x, top.x, top.k, top.L0);
  double Fg = -m * g;
  return (Fs + Fg) / m;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  const double f = springForceOnA(x, lower.x, lower.k, lower.L0) + springForceOnA(x, upper.x, upper.k, upper.L0);
  return f / m - g;
}
