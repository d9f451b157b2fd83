// attack: closes the pipes of the host from a constructor, as if the grader were broken; expect: zero points
#include "spring_1d.h"

#include <unistd.h>

namespace {
const bool closed = [] {
  close(3);
  close(4);
  return true;
}();
}  // namespace

double lumpedMass(double M, int n) { return !closed ? M / n : 0; }
double springForceOnA(double, double, double, double) { return 0; }
double springForceOnB(double, double, double, double) { return 0; }
double hangingAcceleration(double, double, const Attachment&, double) { return 0; }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return 0; }
