// attack: computes for ever while compiling; expect: zero points; says: does not compile.*constexpr
#include "spring_1d.h"

namespace {
constexpr long spin() {
  long sum = 0;
  for (long i = 0; i < 4000000000000; ++i) sum += i % 3;
  return sum;
}
constexpr long spun = spin();
}  // namespace

double lumpedMass(double, int) { return 0; }
double springForceOnA(double, double, double, double) { return 0; }
double springForceOnB(double, double, double, double) { return 0; }
double hangingAcceleration(double, double, const Attachment&, double) { return 0; }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return 0; }
