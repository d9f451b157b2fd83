#include "spring_1d.h"

// The direction by comparison, one helper for everything.

namespace {

double pull(double from, double to, double k, double L0) {
  if (to > from) return k * (to - from - L0);
  if (to < from) return -k * (from - to - L0);
  return 0.0;
}

}  // namespace

double lumpedMass(double M, int n) {
  const double share = 1.0 / n;
  return share * M;
}

double springForceOnA(double xa, double xb, double k, double L0) { return pull(xa, xb, k, L0); }

double springForceOnB(double xa, double xb, double k, double L0) { return pull(xb, xa, k, L0); }

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  double force = -m * g;
  force += pull(x, top.x, top.k, top.L0);
  return force / m;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  return hangingAcceleration(x, m, lower, g) + hangingAcceleration(x, m, upper, g) + g;
}
