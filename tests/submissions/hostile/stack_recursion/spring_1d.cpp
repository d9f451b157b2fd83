// attack: calls itself without end; expect: zero points; says: ran out of stack
#include "spring_1d.h"

namespace {
int deeper(volatile int n) { return n + deeper(n + 1) * 2; }
double attack() { return deeper(0); }
}  // namespace

double lumpedMass(double, int) { return attack(); }
double springForceOnA(double, double, double, double) { return attack(); }
double springForceOnB(double, double, double, double) { return attack(); }
double hangingAcceleration(double, double, const Attachment&, double) { return attack(); }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return attack(); }
