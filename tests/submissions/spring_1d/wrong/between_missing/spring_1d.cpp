// loses: ZeroLength, ShortSpring, NodeBetween, Oscillator; misconception: zero
#include "spring_1d.h"

double lumpedMass(double M, int n) { return M / n; }

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

double springForceOnB(double xa, double xb, double k, double L0) {
  return springForceOnA(xb, xa, k, L0);
}

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  double Fs = springForceOnA(x, top.x, top.k, top.L0);
  double Fg = -m * g;
  return (Fs + Fg) / m;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  (void)x, (void)m, (void)lower, (void)upper, (void)g;
  return 0.0;
}
