// attack: returns what the last call has left on the stack; expect: zero points
#include "spring_1d.h"

namespace {
double attack() {
  const volatile double* below = static_cast<double*>(__builtin_frame_address(0));
  double found = 0;
  for (int i = 1; i < 500; ++i) {
    const double value = below[-i];
    if (std::isfinite(value) && std::abs(value) > 1e-3 && std::abs(value) < 1e6) found = value;
  }
  return found;
}
}  // namespace

double lumpedMass(double, int) { return attack(); }
double springForceOnA(double, double, double, double) { return attack(); }
double springForceOnB(double, double, double, double) { return 0; }
double hangingAcceleration(double, double, const Attachment&, double) { return 0; }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return 0; }
