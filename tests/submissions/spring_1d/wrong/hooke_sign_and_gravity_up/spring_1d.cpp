// loses: HookeForce, CrossedNodes, HangingNode, NodeBetween, Oscillator; misconception: wrong_sign or gravity_up
// two mistakes: plus k (L - L0), and gravity added with plus
#include "spring_1d.h"

double lumpedMass(double M, int n) { return M / n; }

double springForceOnA(double xa, double xb, double k, double L0) {
  double L = std::abs(xa - xb);
  if (L == 0) return 0;
  double dir = (xa - xb) / L;
  return k * (L - L0) * dir;
}

double springForceOnB(double xa, double xb, double k, double L0) { return -springForceOnA(xa, xb, k, L0); }

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  return springForceOnA(x, top.x, top.k, top.L0) / m + g;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  double F1 = springForceOnA(x, lower.x, lower.k, lower.L0);
  double F2 = springForceOnA(x, upper.x, upper.k, upper.L0);
  return (F1 + F2) / m + g;
}
