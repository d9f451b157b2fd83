// attack: traces another process; expect: zero points; says: ptrace
#include "spring_1d.h"

#include <sys/ptrace.h>

namespace {
double attack() { return static_cast<double>(ptrace(PTRACE_ATTACH, 1, nullptr, nullptr)); }
}  // namespace

double lumpedMass(double, int) { return attack(); }
double springForceOnA(double, double, double, double) { return attack(); }
double springForceOnB(double, double, double, double) { return attack(); }
double hangingAcceleration(double, double, const Attachment&, double) { return attack(); }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return attack(); }
