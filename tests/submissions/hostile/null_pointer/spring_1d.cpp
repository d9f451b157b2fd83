// attack: writes through a null pointer; expect: zero points; says: memory that is not its own[\s\S]*lumpedMass\(
#include "spring_1d.h"

namespace {
double attack() {
  volatile double* volatile nothing = nullptr;
  *nothing = 1;
  return 0;
}
}  // namespace

double lumpedMass(double, int) { return attack(); }
double springForceOnA(double, double, double, double) { return attack(); }
double springForceOnB(double, double, double, double) { return attack(); }
double hangingAcceleration(double, double, const Attachment&, double) { return attack(); }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return attack(); }
