// loses: HookeForce, CrossedNodes; misconception: length_squared
// thought: r / L^2 is the unit vector
#include "spring_1d.h"

double lumpedMass(double M, int n) {
  return M / static_cast<double>(n);
}

double springForceOnA(double xa, double xb, double k, double L0) {
  const double r = xa - xb;
  const double L2 = r * r;
  if (r == 0.0) return 0.0;
  return -k * (std::sqrt(L2) - L0) * r / L2;
}

double springForceOnB(double xa, double xb, double k, double L0) {
  double onA = springForceOnA(xa, xb, k, L0);
  return -onA;
}

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  return springForceOnA(x, top.x, top.k, top.L0) / m - g;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  double force = 0.0;
  for (const Attachment& s : {lower, upper}) {
    force += springForceOnA(x, s.x, s.k, s.L0);
  }
  return force / m - g;
}
