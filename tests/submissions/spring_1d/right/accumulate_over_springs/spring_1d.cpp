#include "spring_1d.h"

#include <numeric>

namespace {

double netAcceleration(double x, double m, double g, const std::vector<Attachment>& springs) {
  const double force = std::accumulate(springs.begin(), springs.end(), 0.0, [x](double sum, const Attachment& s) {
    return sum + springForceOnA(x, s.x, s.k, s.L0);
  });
  return force / m - g;
}

}  // namespace

double lumpedMass(double M, int n) { return M / double(n); }

double springForceOnA(double xa, double xb, double k, double L0) {
  const double L = std::max(xa, xb) - std::min(xa, xb);
  if (L == 0.0) return 0.0;
  return (L0 - L) * k * ((xa - xb) / L);
}

double springForceOnB(double xa, double xb, double k, double L0) {
  return 0.0 - springForceOnA(xa, xb, k, L0);  // actio = reactio
}

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  return netAcceleration(x, m, g, {top});
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  return netAcceleration(x, m, g, {lower, upper});
}
