// attack: writes without end to the pipe of answers; expect: zero points; says: malformed|not asked|message of
#include "spring_1d.h"

#include <unistd.h>
#include <cstring>

namespace {
double attack() {
  char block[65536];
  std::memset(block, 0x6c, sizeof block);
  while (write(4, block, sizeof block) > 0) {
  }
  return 0;
}
}  // namespace

double lumpedMass(double, int) { return attack(); }
double springForceOnA(double, double, double, double) { return attack(); }
double springForceOnB(double, double, double, double) { return attack(); }
double hangingAcceleration(double, double, const Attachment&, double) { return attack(); }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return attack(); }
