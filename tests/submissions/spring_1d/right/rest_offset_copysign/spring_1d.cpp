#include "spring_1d.h"

double lumpedMass(double M, int n) { return M / n; }

double springForceOnA(double xa, double xb, double k, double L0) {
  const double d = xa - xb;
  // The spring wants d to be +L0 or -L0, on the side where a is now.
  return d == 0.0 ? 0.0 : k * (std::copysign(L0, d) - d);
}

double springForceOnB(double xa, double xb, double k, double L0) {
  const double d = xb - xa;
  return d == 0.0 ? 0.0 : k * (std::copysign(L0, d) - d);
}

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  return -g - springForceOnB(x, top.x, top.k, top.L0) / m;  // minus the force on the ceiling
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  double force = 0;
  for (const Attachment* s : {&upper, &lower}) force += springForceOnA(x, s->x, s->k, s->L0);
  return force / m - g;
}
