#include "spring_1d.h"

double lumpedMass(double M, int n) {
  if (n == 1) return M;
  return M / n;
}

double springForceOnA(double xa, double xb, double k, double L0) {
  if (xa > xb) {
    // a is the upper node: a long spring pulls it down
    return -k * (xa - xb - L0);
  } else if (xa < xb) {
    // a is the lower node: a long spring pulls it up
    return k * (xb - xa - L0);
  } else {
    return 0;
  }
}

double springForceOnB(double xa, double xb, double k, double L0) {
  if (xb > xa) {
    return -k * (xb - xa - L0);
  } else if (xb < xa) {
    return k * (xa - xb - L0);
  } else {
    return 0;
  }
}

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  double a = -g;
  a += springForceOnA(x, top.x, top.k, top.L0) / m;
  return a;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  double a = hangingAcceleration(x, m, upper, g);
  a += springForceOnA(x, lower.x, lower.k, lower.L0) / m;
  return a;
}
