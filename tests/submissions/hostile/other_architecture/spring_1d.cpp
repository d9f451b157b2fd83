// attack: forks through the 32-bit door of the kernel; expect: zero points; says: asked the operating system|memory that is not its own
#include "spring_1d.h"

namespace {
double attack() {
  long result = 2;
  asm volatile("int $0x80" : "+a"(result) : : "memory");
  return static_cast<double>(result);
}
}  // namespace

double lumpedMass(double, int) { return attack(); }
double springForceOnA(double, double, double, double) { return attack(); }
double springForceOnB(double, double, double, double) { return attack(); }
double hangingAcceleration(double, double, const Attachment&, double) { return attack(); }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return attack(); }
