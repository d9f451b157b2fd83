// attack: prints without end; expect: zero points; says: did not return within 2 s
#include "spring_1d.h"

#include <cstdio>

namespace {
double attack() {
  for (;;) {
    std::fputs("0123456789012345678901234567890123456789012345678901234567890123\n", stdout);
    std::fputs("and to the other stream\n", stderr);
  }
}
}  // namespace

double lumpedMass(double, int) { return attack(); }
double springForceOnA(double, double, double, double) { return 0; }
double springForceOnB(double, double, double, double) { return 0; }
double hangingAcceleration(double, double, const Attachment&, double) { return 0; }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return 0; }
