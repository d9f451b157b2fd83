// attack: looks who has started it; expect: zero points; says: getppid
#include "spring_1d.h"

#include <unistd.h>

namespace {
double attack() { return getppid() == 1; }
}  // namespace

double lumpedMass(double, int) { return attack(); }
double springForceOnA(double, double, double, double) { return attack(); }
double springForceOnB(double, double, double, double) { return attack(); }
double hangingAcceleration(double, double, const Attachment&, double) { return attack(); }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return attack(); }
