// loses: HookeForce, CrossedNodes, ShortSpring; misconception: single_precision
#include "spring_1d.h"

static float hooke(float distance, float k, float L0) { return -k * (distance - L0); }

double lumpedMass(double M, int n) { return M / n; }

double springForceOnA(double xa, double xb, double k, double L0) {
  float distance = std::abs(xa - xb);
  if (distance == 0) return 0;
  return xa > xb ? hooke(distance, k, L0) : -hooke(distance, k, L0);
}

double springForceOnB(double xa, double xb, double k, double L0) { return -springForceOnA(xa, xb, k, L0); }

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  return springForceOnA(x, top.x, top.k, top.L0) / m - g;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  double f = springForceOnA(x, lower.x, lower.k, lower.L0);
  f += springForceOnA(x, upper.x, upper.k, upper.L0);
  return f / m - g;
}
