// attack: ignores the signal that asks it to end; expect: zero points; says: rt_sigaction
#include "spring_1d.h"

#include <csignal>

namespace {
double attack() {
  std::signal(SIGTERM, SIG_IGN);
  return 0;
}
}  // namespace

double lumpedMass(double, int) { return attack(); }
double springForceOnA(double, double, double, double) { return attack(); }
double springForceOnB(double, double, double, double) { return attack(); }
double hangingAcceleration(double, double, const Attachment&, double) { return attack(); }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return attack(); }
