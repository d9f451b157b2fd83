// loses: ZeroLength, NodeBetween; misconception: signed_length
// writes the slide's picture down: the lower spring is x - lower.x long, the upper one upper.x - x
#include "spring_1d.h"

double lumpedMass(double M, int n) { return M / n; }

double springForceOnA(double xa, double xb, double k, double L0) {
  const double L = std::abs(xa - xb);
  return L == 0 ? 0.0 : -k * (L - L0) * (xa - xb) / L;
}

double springForceOnB(double xa, double xb, double k, double L0) {
  const double L = std::abs(xa - xb);
  return L == 0 ? 0.0 : k * (L - L0) * (xa - xb) / L;
}

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  return springForceOnA(x, top.x, top.k, top.L0) / m - g;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  const double lengthBelow = x - lower.x;
  const double lengthAbove = upper.x - x;
  const double down = lower.k * (lengthBelow - lower.L0);
  const double up = upper.k * (lengthAbove - upper.L0);
  return (up - down) / m - g;
}
