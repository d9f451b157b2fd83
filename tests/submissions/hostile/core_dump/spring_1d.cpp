// attack: dies with a core of its memory; expect: zero points; says: was stopped
#include "spring_1d.h"

#include <csignal>
#include <vector>

namespace {
double attack() {
  std::vector<char> ballast(500UL << 20, 1);
  raise(SIGQUIT);
  return ballast[3];
}
}  // namespace

double lumpedMass(double, int) { return attack(); }
double springForceOnA(double, double, double, double) { return attack(); }
double springForceOnB(double, double, double, double) { return attack(); }
double hangingAcceleration(double, double, const Attachment&, double) { return attack(); }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return attack(); }
