// attack: reads and writes every descriptor that it may have inherited; expect: zero points
#include "spring_1d.h"

#include <unistd.h>

namespace {
double attack() {
  char bytes[64];
  double found = 0;
  for (int i = 5; i < 1024; ++i) found += read(i, bytes, sizeof bytes) >= 0 || write(i, "1", 1) >= 0;
  return found > 0 ? 1 : 0;
}
}  // namespace

double lumpedMass(double, int) { return attack(); }
double springForceOnA(double, double, double, double) { return attack(); }
double springForceOnB(double, double, double, double) { return attack(); }
double hangingAcceleration(double, double, const Attachment&, double) { return attack(); }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return attack(); }
