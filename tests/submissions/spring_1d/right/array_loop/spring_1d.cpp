#include "spring_1d.h"

double lumpedMass(double M, int n) {
  return M * std::pow(static_cast<double>(n), -1.0);
}

double springForceOnA(double xa, double xb, double k, double L0) {
  double L = xa - xb;
  int up = 1;
  if (L < 0) {
    L = -L;
    up = -1;
  }
  if (L == 0) up = 0;
  return up * -k * (L - L0);
}

double springForceOnB(double xa, double xb, double k, double L0) {
  return springForceOnA(-xa, -xb, k, L0);  // the mirrored spring
}

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  return (springForceOnA(x, top.x, top.k, top.L0) - m * g) / m;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  const std::array<const Attachment*, 2> springs = {&lower, &upper};
  double force = 0;
  for (std::size_t i = 0; i < springs.size(); i++) {
    const Attachment& s = *springs[i];
    force += springForceOnA(x, s.x, s.k, s.L0);
  }
  return force / m - g;
}
