#include "spring_1d.h"

namespace {

double sumOfForces(double x, std::initializer_list<Attachment> springs) {
  double sum = 0;
  for (const auto& [end, k, L0] : springs) sum += springForceOnA(x, end, k, L0);
  return sum;
}

}  // namespace

double lumpedMass(double M, int n) { return M / n; }

double springForceOnA(double xa, double xb, double k, double L0) {
  const double r = xa - xb;
  return r == 0 ? 0 : k * (std::copysign(L0, r) - r);
}

double springForceOnB(double xa, double xb, double k, double L0) {
  const double r = xb - xa;
  return r == 0 ? 0 : k * (std::copysign(L0, r) - r);
}

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  return sumOfForces(x, {top}) / m - g;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  return sumOfForces(x, {lower, upper}) / m - g;
}
