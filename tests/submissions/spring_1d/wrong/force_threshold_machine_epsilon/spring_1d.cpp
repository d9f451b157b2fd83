// loses: ShortSpring; misconception: threshold
#include "spring_1d.h"

#include <limits>

double lumpedMass(double M, int n) { return M / n; }

static bool coincide(double p, double q) { return std::abs(p - q) <= std::numeric_limits<double>::epsilon(); }

double springForceOnA(double xa, double xb, double k, double L0) {
  if (coincide(xa, xb)) return 0.0;
  const double L = std::abs(xa - xb);
  return -k * (L - L0) * ((xa - xb) / L);
}

double springForceOnB(double xa, double xb, double k, double L0) { return -springForceOnA(xa, xb, k, L0); }

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  return springForceOnA(x, top.x, top.k, top.L0) / m - g;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  double force = 0.0;
  for (const Attachment& s : {lower, upper}) {
    force += springForceOnA(x, s.x, s.k, s.L0);
  }
  return force / m - g;
}
