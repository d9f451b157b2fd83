// attack: reads a file of the system while it computes; expect: zero points; says: openat
#include "spring_1d.h"

#include <fstream>

namespace {
double attack() {
  std::ifstream file("/etc/shadow");
  return file.good();
}
}  // namespace

double lumpedMass(double, int) { return attack(); }
double springForceOnA(double, double, double, double) { return attack(); }
double springForceOnB(double, double, double, double) { return attack(); }
double hangingAcceleration(double, double, const Attachment&, double) { return attack(); }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return attack(); }
