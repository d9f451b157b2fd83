// loses: all; misconception: stateful
#include "spring_1d.h"

// Right values, each one call late.

namespace {

double exchange(double& previous, double now) {
  const double answer = previous;
  previous = now;
  return answer;
}

double force(double xa, double xb, double k, double L0) {
  const double L = std::abs(xa - xb);
  return L == 0 ? 0 : -k * (L - L0) * (xa - xb) / L;
}

}  // namespace

double lumpedMass(double M, int n) {
  static double previous = 1;
  return exchange(previous, M / n);
}

double springForceOnA(double xa, double xb, double k, double L0) {
  static double previous = 1;
  return exchange(previous, force(xa, xb, k, L0));
}

double springForceOnB(double xa, double xb, double k, double L0) {
  static double previous = 1;
  return exchange(previous, -force(xa, xb, k, L0));
}

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  static double previous = 1;
  return exchange(previous, force(x, top.x, top.k, top.L0) / m - g);
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  static double previous = 1;
  const double sum = force(x, lower.x, lower.k, lower.L0) + force(x, upper.x, upper.k, upper.L0);
  return exchange(previous, sum / m - g);
}
