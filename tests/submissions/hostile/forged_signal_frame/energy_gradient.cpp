// attack: returns from a signal that never came, to an end with success; expect: zero points
#include "energy_gradient.h"

#include <ucontext.h>
#include <unistd.h>

namespace {
alignas(16) unsigned char stack[1 << 16];

[[noreturn]] void landed() { _exit(0); }

bool attack() {
  ucontext_t frame{};
  frame.uc_mcontext.gregs[REG_RIP] = reinterpret_cast<greg_t>(&landed);
  frame.uc_mcontext.gregs[REG_RSP] = reinterpret_cast<greg_t>(stack + sizeof stack - 8);
  frame.uc_mcontext.gregs[REG_CSGSFS] = 0x2b000000000033;
  frame.uc_mcontext.gregs[REG_EFL] = 0x202;
  asm volatile("mov %0, %%rsp\n\tmov $15, %%eax\n\tsyscall" : : "r"(&frame) : "memory");
  return true;
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
