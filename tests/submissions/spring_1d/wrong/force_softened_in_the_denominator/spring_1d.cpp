// loses: ShortSpring; misconception: softened_length
#include "spring_1d.h"

double lumpedMass(double M, int n) {
  return M / static_cast<double>(n);
}

double springForceOnA(double xa, double xb, double k, double L0) {
  double L = fabs(xa - xb);
  return -k * (L - L0) * (xa - xb) / (L + 1e-15);
}

double springForceOnB(double xa, double xb, double k, double L0) { return -springForceOnA(xa, xb, k, L0); }

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  double Fs = springForceOnA(x, top.x, top.k, top.L0);
  double Fg = -m * g;
  return (Fs + Fg) / m;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  double force = 0.0;
  for (const Attachment& s : {lower, upper}) {
    force += springForceOnA(x, s.x, s.k, s.L0);
  }
  return force / m - g;
}
