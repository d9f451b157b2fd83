// attack: kills every process that it may; expect: zero points; says: 'kill'
#include "spring_1d.h"

#include <csignal>

namespace {
double attack() { return kill(-1, SIGKILL); }
}  // namespace

double lumpedMass(double, int) { return attack(); }
double springForceOnA(double, double, double, double) { return attack(); }
double springForceOnB(double, double, double, double) { return attack(); }
double hangingAcceleration(double, double, const Attachment&, double) { return attack(); }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return attack(); }
