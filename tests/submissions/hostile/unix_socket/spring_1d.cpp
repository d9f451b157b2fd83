// attack: opens an abstract socket as a channel between runs; expect: zero points; says: socket
#include "spring_1d.h"

#include <sys/socket.h>

namespace {
double attack() { return socket(AF_UNIX, SOCK_DGRAM, 0); }
}  // namespace

double lumpedMass(double, int) { return attack(); }
double springForceOnA(double, double, double, double) { return attack(); }
double springForceOnB(double, double, double, double) { return attack(); }
double hangingAcceleration(double, double, const Attachment&, double) { return attack(); }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return attack(); }
