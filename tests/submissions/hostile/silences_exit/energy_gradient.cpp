// attack: forbids the process to end, then ends it; expect: zero points
#include "energy_gradient.h"

#include <fcntl.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>
#include <cstddef>
#include <iterator>

namespace {
const long installed = [] {
  sock_filter rules[] = {
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_exit_group, 0, 1),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | 0),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_exit, 0, 1),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | 0),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
  };
  const sock_fprog program{static_cast<unsigned short>(std::size(rules)), rules};
  return syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, 0, &program);
}();

bool attack() {
  _exit(0);
  return installed == 0;
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
