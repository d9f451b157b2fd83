#include "spring_1d.h"
#include <functional>
double lumpedMass(double M, int n) { return [=] { return M / static_cast<double>(n); }(); }
double springForceOnA(double xa, double xb, double k, double L0) {
  double stretched, sign;
  if (xa > xb) { stretched = xa - xb - L0; sign = -1; }
  else if (xa < xb) { stretched = xb - xa - L0; sign = +1; }
  else { stretched = 0; sign = 0; }
  return sign * k * stretched;
}
double springForceOnB(double xa, double xb, double k, double L0) { return 0.0 - springForceOnA(xa, xb, k, L0); }
double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  std::function<double(const Attachment&)> pull = [x](const Attachment& a) { return springForceOnA(x, a.x, a.k, a.L0); };
  return std::fma(-1.0, g, pull(top) / m);
}
double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  double sum = -m * g;
  for (const Attachment* a : {&upper, &lower}) sum += springForceOnA(x, a->x, a->k, a->L0);
  return sum / m;
}
