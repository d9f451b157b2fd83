// attack: starts a thread while it is loaded; expect: zero points; says: clone|rt_sigaction
#include "spring_1d.h"

#include <unistd.h>
#include <thread>

namespace {
std::thread spinner([] {
  for (;;) _exit(0);
});
}  // namespace

double lumpedMass(double M, int n) { return M / n; }
double springForceOnA(double xa, double xb, double k, double L0) {
  const double L = std::abs(xa - xb);
  return L == 0 ? 0 : -k * (L - L0) * (xa - xb) / L;
}
double springForceOnB(double xa, double xb, double k, double L0) { return -springForceOnA(xa, xb, k, L0); }
double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  return springForceOnA(x, top.x, top.k, top.L0) / m - g;
}
double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  return hangingAcceleration(x, m, lower, g) + hangingAcceleration(x, m, upper, 0);
}
