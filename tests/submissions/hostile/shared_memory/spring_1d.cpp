// attack: leaves its answers in shared memory; expect: zero points; says: asked the operating system
#include "spring_1d.h"

#include <sys/ipc.h>
#include <sys/shm.h>

namespace {
double attack() { return shmget(4711, 4096, IPC_CREAT | 0666); }
}  // namespace

double lumpedMass(double, int) { return attack(); }
double springForceOnA(double, double, double, double) { return attack(); }
double springForceOnB(double, double, double, double) { return attack(); }
double hangingAcceleration(double, double, const Attachment&, double) { return attack(); }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return attack(); }
