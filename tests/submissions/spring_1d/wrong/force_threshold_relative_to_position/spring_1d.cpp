// loses: ShortSpring; misconception: threshold
// thought: floating-point numbers must be compared with a relative tolerance
#include "spring_1d.h"

double lumpedMass(double M, int n) {
  // every node gets the same
  return M / (double)n;
}

static bool nearlyEqual(double p, double q) {
  return std::abs(p - q) <= 1e-9 * std::max(std::abs(p), std::abs(q));
}

double springForceOnA(double xa, double xb, double k, double L0) {
  if (nearlyEqual(xa, xb)) return 0.0;
  const double L = std::abs(xa - xb);
  return -k * (L - L0) * (xa - xb) / L;
}

double springForceOnB(double xa, double xb, double k, double L0) { return -springForceOnA(xa, xb, k, L0); }

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  return springForceOnA(x, top.x, top.k, top.L0) / m - g;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  double Fl = springForceOnA(x, lower.x, lower.k, lower.L0);
  double Fu = springForceOnA(x, upper.x, upper.k, upper.L0);
  double Fg = -m * g;
  return (Fl + Fu + Fg) / m;
}
