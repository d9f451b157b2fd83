// attack: runs a shell; expect: zero points; says: was stopped
#include "spring_1d.h"

#include <cstdlib>

namespace {
double attack() { return std::system("cat /etc/shadow"); }
}  // namespace

double lumpedMass(double, int) { return attack(); }
double springForceOnA(double, double, double, double) { return attack(); }
double springForceOnB(double, double, double, double) { return attack(); }
double hangingAcceleration(double, double, const Attachment&, double) { return attack(); }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return attack(); }
