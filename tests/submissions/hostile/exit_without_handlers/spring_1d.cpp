// attack: ends the program with success, without handlers; expect: zero points; says: exit\(0\)
#include "spring_1d.h"

#include <unistd.h>

namespace {
double attack() { _exit(0); }
}  // namespace

double lumpedMass(double, int) { return attack(); }
double springForceOnA(double, double, double, double) { return attack(); }
double springForceOnB(double, double, double, double) { return attack(); }
double hangingAcceleration(double, double, const Attachment&, double) { return attack(); }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return attack(); }
