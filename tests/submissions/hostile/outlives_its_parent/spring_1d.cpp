// attack: asks not to be ended with its parent, and to be traced and dumped; expect: zero points
#include "spring_1d.h"

#include <sys/prctl.h>

namespace {
const bool changed = [] {
  const bool alive = prctl(PR_SET_PDEATHSIG, 0, 0, 0, 0) == 0;
  return prctl(PR_SET_DUMPABLE, 1, 0, 0, 0) == 0 || alive;
}();
}  // namespace

double lumpedMass(double M, int n) { return changed ? M / n : 0; }
double springForceOnA(double, double, double, double) { return 0; }
double springForceOnB(double, double, double, double) { return 0; }
double hangingAcceleration(double, double, const Attachment&, double) { return 0; }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return 0; }
