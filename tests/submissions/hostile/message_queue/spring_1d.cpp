// attack: leaves its answers in a message queue, from a constructor; expect: zero points; says: asked the operating system
#include "spring_1d.h"

#include <sys/ipc.h>
#include <sys/msg.h>

namespace {
const int queue = msgget(4711, IPC_CREAT | 0666);
}  // namespace

double lumpedMass(double M, int n) { return M / n; }
double springForceOnA(double xa, double xb, double k, double L0) {
  const double L = std::abs(xa - xb);
  return L == 0 ? 0 : -k * (L - L0) * (xa - xb) / L;
}
double springForceOnB(double xa, double xb, double k, double L0) { return -springForceOnA(xa, xb, k, L0); }
double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  return springForceOnA(x, top.x, top.k, top.L0) / m - g;
}
double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  return hangingAcceleration(x, m, lower, g) + hangingAcceleration(x, m, upper, 0);
}
