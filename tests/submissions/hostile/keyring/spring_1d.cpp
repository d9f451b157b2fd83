// attack: leaves its answers in a keyring; expect: zero points; says: asked the operating system
#include "spring_1d.h"

#include <sys/syscall.h>
#include <unistd.h>

namespace {
double attack() { return static_cast<double>(syscall(SYS_add_key, "user", "answers", "1", 1, -4)); }
}  // namespace

double lumpedMass(double, int) { return attack(); }
double springForceOnA(double, double, double, double) { return attack(); }
double springForceOnB(double, double, double, double) { return attack(); }
double hangingAcceleration(double, double, const Attachment&, double) { return attack(); }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return attack(); }
