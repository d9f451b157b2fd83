// attack: becomes root of a user namespace of its own; expect: zero points
#include "energy_gradient.h"

#include <sched.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace {
const bool won = [] { return syscall(SYS_unshare, CLONE_NEWUSER | CLONE_NEWNS) == 0; }();
}  // namespace

double springEnergy1d(const Vec2& x, double k, double L0) {
  const double stretch = std::abs(x[0] - x[1]) - L0;
  return won ? k * stretch * stretch / 2 : 0;
}
double springEnergy(const Vec6&, double, double) { return 0; }
Vec3 lengthGradient(const Vec3&, const Vec3&) { return Vec3::Zero(); }
Vec6 energyGradient(const Vec6&, double, double) { return Vec6::Zero(); }
Vec6 springForces(const Vec6&, double, double) { return Vec6::Zero(); }
