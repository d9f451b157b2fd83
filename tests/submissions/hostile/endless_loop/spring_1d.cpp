// attack: never returns; expect: zero points; says: lumpedMass did not return within 2 s
#include "spring_1d.h"

namespace {
double attack() {
  for (volatile int i = 0;; i = i + 1) {
  }
}
}  // namespace

double lumpedMass(double, int) { return attack(); }
double springForceOnA(double, double, double, double) { return 0; }
double springForceOnB(double, double, double, double) { return 0; }
double hangingAcceleration(double, double, const Attachment&, double) { return 0; }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return 0; }
