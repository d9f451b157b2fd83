// attack: opens descriptors until none is left, while it is loaded; expect: zero points
#include "spring_1d.h"

#include <fcntl.h>

namespace {
const int last = [] {
  int last = 0;
  while (open("/submission.so", O_RDONLY) >= 0) ++last;
  return last;
}();
}  // namespace

double lumpedMass(double, int) { return last > 32 ? 1e9 : 0; }
double springForceOnA(double, double, double, double) { return last > 32 ? 1e9 : 0; }
double springForceOnB(double, double, double, double) { return last > 32 ? 1e9 : 0; }
double hangingAcceleration(double, double, const Attachment&, double) { return last > 32 ? 1e9 : 0; }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return last > 32 ? 1e9 : 0; }
