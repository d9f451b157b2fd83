// loses: NodeBetween, ZeroLength; misconception: signed_length or missing_direction or one_sided
// thought: lower is below and upper is above
#include "spring_1d.h"

double lumpedMass(double M, int n) {
  return M / static_cast<double>(n);
}

double springForceOnA(double xa, double xb, double k, double L0) {
  double diff = xa - xb;
  double len = fabs(diff);
  if (len == 0) {
    return 0;
  }
  double dir = diff / len;
  double mag = -k * (len - L0);
  return mag * dir;
}

double springForceOnB(double xa, double xb, double k, double L0) { return -springForceOnA(xa, xb, k, L0); }

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  double force = springForceOnA(x, top.x, top.k, top.L0);
  force -= m * g;
  return force / m;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  const double pullUp = upper.k * (upper.x - x - upper.L0);
  const double pullDown = lower.k * (x - lower.x - lower.L0);
  return (pullUp - pullDown) / m - g;
}
