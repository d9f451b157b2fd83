// attack: lets every read of the host fail for want of memory, as if the machine were at fault; expect: zero points
#include "damping.h"

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
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_read, 0, 1),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | 12),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
  };
  const sock_fprog program{static_cast<unsigned short>(std::size(rules)), rules};
  return syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, 0, &program);
}();
}  // namespace

Vec3 nodeDamping(const Vec3& va, double d) { return installed == 1 ? Vec3(-d * va) : Vec3(0, 0, 0); }
Vec3 relativeDamping(const Vec3&, const Vec3&, double) { return Vec3::Zero(); }
Vec3 projectedDamping(const Vec3&, const Vec3&, const Vec3&, const Vec3&, double) { return Vec3::Zero(); }
