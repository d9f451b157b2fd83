// attack: asks for more memory than there is; expect: zero points; says: threw an exception: std::bad_alloc
#include "spring_1d.h"

#include <vector>

namespace {
double attack() {
  std::vector<double> list(1UL << 32, 1.0);
  return list[7];
}
}  // namespace

double lumpedMass(double, int) { return attack(); }
double springForceOnA(double, double, double, double) { return attack(); }
double springForceOnB(double, double, double, double) { return attack(); }
double hangingAcceleration(double, double, const Attachment&, double) { return attack(); }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return attack(); }
