// loses: LumpedMass; misconception: stateful or constant
// thought: compute it only once, for speed
#include "spring_1d.h"

double lumpedMass(double M, int n) {
  static const double perNode = M / n;
  return perNode;
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
  return springForceOnA(x, top.x, top.k, top.L0) / m - g;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  double force = 0.0;
  for (const Attachment& s : {lower, upper}) {
    force += springForceOnA(x, s.x, s.k, s.L0);
  }
  return force / m - g;
}
