// attack: leaves a process behind; expect: zero points; says: clone|fork
#include "spring_1d.h"

#include <unistd.h>

namespace {
double attack() {
  if (fork() == 0) {
    setsid();
    for (;;) pause();
  }
  return 0;
}
}  // namespace

double lumpedMass(double, int) { return attack(); }
double springForceOnA(double, double, double, double) { return attack(); }
double springForceOnB(double, double, double, double) { return attack(); }
double hangingAcceleration(double, double, const Attachment&, double) { return attack(); }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return attack(); }
