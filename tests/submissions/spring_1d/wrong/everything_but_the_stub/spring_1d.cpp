// loses: all; misconception: zero
// handed in without doing anything that returns
#include "spring_1d.h"

double lumpedMass(double M, int n) {
  double m = M / n;
  (void)m;
  return 0.0;
}

double springForceOnA(double xa, double xb, double k, double L0) {
  double F = -k * (fabs(xa - xb) - L0);
  (void)F;
  return 0.0;
}

double springForceOnB(double, double, double, double) {
  return 0.0;
}

double hangingAcceleration(double, double, const Attachment&, double) {
  return 0.0;
}

double accelerationBetween(double, double, const Attachment&, const Attachment&, double) {
  return 0.0;
}
