// loses: HangingNode, Oscillator; misconception: multiplied_by_mass or multiplied_for_divided
#include "spring_1d.h"

double lumpedMass(double M, int n) {
  return M / static_cast<double>(n);
}

double springForceOnA(double xa, double xb, double k, double L0) {
  double delta = xb - xa;
  double length = std::abs(delta);
  if (!(length > 0)) return 0;
  return k * (length - L0) * (delta / length);
}

double springForceOnB(double xa, double xb, double k, double L0) {
  double onA = springForceOnA(xa, xb, k, L0);
  return -onA;
}

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  return m * springForceOnA(x, top.x, top.k, top.L0) - g;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  double force = 0.0;
  for (const Attachment& s : {lower, upper}) {
    force += springForceOnA(x, s.x, s.k, s.L0);
  }
  return force / m - g;
}
