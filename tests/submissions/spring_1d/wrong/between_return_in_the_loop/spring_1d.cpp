// loses: NodeBetween, Oscillator; misconception: lower_spring_only or last_skipped or first_only
// return in the loop
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
  double onA = springForceOnA(xa, xb, k, L0);
  return -onA;
}

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  double Fs = springForceOnA(x, top.x, top.k, top.L0);
  double Fg = -m * g;
  return (Fs + Fg) / m;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  const std::array<Attachment, 2> springs = {lower, upper};
  double force = -m * g;
  for (const auto& s : springs) {
    force += springForceOnA(x, s.x, s.k, s.L0);
    return force / m;
  }
  return force / m;
}
