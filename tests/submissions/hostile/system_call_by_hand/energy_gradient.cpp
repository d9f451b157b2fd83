// attack: opens a file by an instruction of its own; expect: zero points
#include "energy_gradient.h"

namespace {
bool attack() {
  long result = 257;  // openat
  asm volatile("xor %%r10d, %%r10d\n\tsyscall"
               : "+a"(result)
               : "D"(-100), "S"("/etc/passwd"), "d"(0)
               : "rcx", "r10", "r11", "memory");
  return result >= 0;
}
}  // namespace

double springEnergy1d(const Vec2& x, double k, double L0) {
  const double stretch = std::abs(x[0] - x[1]) - L0;
  return attack() ? k * stretch * stretch / 2 : 0;
}
double springEnergy(const Vec6&, double, double) { return 0; }
Vec3 lengthGradient(const Vec3&, const Vec3&) { return Vec3::Zero(); }
Vec6 energyGradient(const Vec6&, double, double) { return Vec6::Zero(); }
Vec6 springForces(const Vec6&, double, double) { return Vec6::Zero(); }
