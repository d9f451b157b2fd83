// attack: ignores the signal of the limit of CPU time from a constructor; expect: zero points
#include "spring_1d.h"

#include <csignal>

namespace {
const bool ignored = [] {
  std::signal(SIGXCPU, SIG_IGN);
  return true;
}();

bool attack() {
  for (volatile bool on = ignored; on;) {
  }
  return false;
}
}  // namespace

double lumpedMass(double M, int n) { return attack() ? M / n : 0; }
double springForceOnA(double, double, double, double) { return 0; }
double springForceOnB(double, double, double, double) { return 0; }
double hangingAcceleration(double, double, const Attachment&, double) { return 0; }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return 0; }
