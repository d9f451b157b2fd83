// attack: ends well in a handler of the signal that it raises; expect: zero points; says: rt_sigaction
#include "spring_1d.h"

#include <unistd.h>
#include <csignal>

namespace {
double attack() {
  std::signal(SIGFPE, [](int) { _exit(0); });
  std::raise(SIGFPE);
  return 0;
}
}  // namespace

double lumpedMass(double, int) { return attack(); }
double springForceOnA(double, double, double, double) { return attack(); }
double springForceOnB(double, double, double, double) { return attack(); }
double hangingAcceleration(double, double, const Attachment&, double) { return attack(); }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return attack(); }
