// loses: LumpedMass; misconception: none
// thought: very light nodes make the simulation explode
#include "spring_1d.h"

double lumpedMass(double M, int n) {
  const double smallest = 1e-3;
  return std::max(smallest, M / n);
}

double springForceOnA(double xa, double xb, double k, double L0) {
  if (xa == xb) return 0.0;
  const double side = xa > xb ? 1.0 : -1.0;
  const double stretch = std::fabs(xa - xb) - L0;
  return -side * k * stretch;
}

double springForceOnB(double xa, double xb, double k, double L0) {
  // third law
  return -springForceOnA(xa, xb, k, L0);
}

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
