// attack: sleeps for ever; expect: zero points; says: clock_nanosleep|nanosleep
#include "spring_1d.h"

#include <chrono>
#include <thread>

namespace {
double attack() {
  std::this_thread::sleep_for(std::chrono::hours(24));
  return 0;
}
}  // namespace

double lumpedMass(double, int) { return attack(); }
double springForceOnA(double, double, double, double) { return attack(); }
double springForceOnB(double, double, double, double) { return attack(); }
double hangingAcceleration(double, double, const Attachment&, double) { return attack(); }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return attack(); }
