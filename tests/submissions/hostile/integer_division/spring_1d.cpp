// attack: divides an integer by zero; expect: zero points; says: divided an integer by zero[\s\S]*lumpedMass\(
#include "spring_1d.h"

namespace {
double attack() {
  volatile int zero = 0;
  return 7 / zero;
}
}  // namespace

double lumpedMass(double, int) { return attack(); }
double springForceOnA(double, double, double, double) { return attack(); }
double springForceOnB(double, double, double, double) { return attack(); }
double hangingAcceleration(double, double, const Attachment&, double) { return attack(); }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return attack(); }
