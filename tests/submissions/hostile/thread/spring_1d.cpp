// attack: computes in a thread; expect: zero points; says: clone|rt_sigaction
#include "spring_1d.h"

#include <thread>

namespace {
double attack() {
  double result = 0;
  std::thread([&result] { result = 1; }).join();
  return result;
}
}  // namespace

double lumpedMass(double, int) { return attack(); }
double springForceOnA(double, double, double, double) { return attack(); }
double springForceOnB(double, double, double, double) { return attack(); }
double hangingAcceleration(double, double, const Attachment&, double) { return attack(); }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return attack(); }
