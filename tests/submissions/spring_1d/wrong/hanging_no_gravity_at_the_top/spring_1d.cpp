// loses: ZeroLength; misconception: edge
// thought: there is no force at L = 0
#include "spring_1d.h"

double lumpedMass(double M, int n) {
  return M / static_cast<double>(n);
}

double springForceOnA(double xa, double xb, double k, double L0) {
  if (xa == xb) return 0.0;
  const double side = xa > xb ? 1.0 : -1.0;
  const double stretch = std::fabs(xa - xb) - L0;
  return -side * k * stretch;
}

double springForceOnB(double xa, double xb, double k, double L0) {
  double onA = springForceOnA(xa, xb, k, L0);
  return -onA;
}

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  if (x == top.x) return 0.0;
  return springForceOnA(x, top.x, top.k, top.L0) / m - g;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  double force = 0.0;
  for (const Attachment& s : {lower, upper}) {
    force += springForceOnA(x, s.x, s.k, s.L0);
  }
  return force / m - g;
}
