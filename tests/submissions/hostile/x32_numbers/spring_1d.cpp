// attack: opens a file by a number of the x32 interface; expect: zero points; says: asked the operating system
#include "spring_1d.h"

#include <unistd.h>

namespace {
double attack() { return static_cast<double>(syscall(0x40000000 + 2, "/etc/passwd", 0)); }
}  // namespace

double lumpedMass(double, int) { return attack(); }
double springForceOnA(double, double, double, double) { return attack(); }
double springForceOnB(double, double, double, double) { return attack(); }
double hangingAcceleration(double, double, const Attachment&, double) { return attack(); }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return attack(); }
