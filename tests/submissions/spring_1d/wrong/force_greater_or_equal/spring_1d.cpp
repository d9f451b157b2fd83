// loses: ZeroLength; misconception: force_at_zero_length
#include "spring_1d.h"

double lumpedMass(double M, int n) {
  return M / static_cast<double>(n);
}

double springForceOnA(double xa, double xb, double k, double L0) {
  if (xa >= xb)
    return k * (L0 - (xa - xb));
  else
    return k * ((xb - xa) - L0);
}

double springForceOnB(double xa, double xb, double k, double L0) {
  double onA = springForceOnA(xa, xb, k, L0);
  return -onA;
}

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  return springForceOnA(x, top.x, top.k, top.L0) / m - g;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  double Fl = springForceOnA(x, lower.x, lower.k, lower.L0);
  double Fu = springForceOnA(x, upper.x, upper.k, upper.L0);
  double Fg = -m * g;
  return (Fl + Fu + Fg) / m;
}
