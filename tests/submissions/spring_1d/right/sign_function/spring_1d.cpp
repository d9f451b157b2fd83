#include "spring_1d.h"

// -1, 0 or +1
static int sign(double value) {
  if (value > 0) return 1;
  if (value < 0) return -1;
  return 0;
}

double lumpedMass(double M, int n) { return M / static_cast<double>(n); }

double springForceOnA(double xa, double xb, double k, double L0) {
  double fromBToA = xa - xb;
  double stretch = std::fabs(fromBToA) - L0;
  return -k * stretch * sign(fromBToA);  // sign is 0 for coincident nodes
}

double springForceOnB(double xa, double xb, double k, double L0) {
  // b is the a of the same spring seen from the other end
  return springForceOnA(xb, xa, k, L0);
}

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  double force = springForceOnA(x, top.x, top.k, top.L0);
  double a = force / m;
  a -= g;
  return a;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  double fromBelow = springForceOnA(x, lower.x, lower.k, lower.L0);
  double fromAbove = springForceOnA(x, upper.x, upper.k, upper.L0);
  return (fromBelow + fromAbove) / m - g;
}
