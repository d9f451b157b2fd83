// attack: meets the instruction that stops a program for a debugger, whose signal could be a stranger's; expect: zero points; says: ran into nowhere
#include "spring_1d.h"

static double attack() {
  __asm__ volatile("int3"); return 0;
}
double lumpedMass(double, int) { return attack(); }
double springForceOnA(double, double, double, double) { return attack(); }
double springForceOnB(double, double, double, double) { return attack(); }
double hangingAcceleration(double, double, const Attachment&, double) { return attack(); }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return attack(); }
