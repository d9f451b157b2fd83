// attack: stops itself by the system call, so that only the wall clock notices; expect: zero points
#include "damping.h"

#include <sys/syscall.h>
#include <unistd.h>
#include <csignal>

namespace {
bool attack() {
  syscall(SYS_tgkill, getpid(), getpid(), SIGSTOP);
  return false;
}
}  // namespace

Vec3 nodeDamping(const Vec3& va, double d) { return attack() ? Vec3(-d * va) : Vec3(0, 0, 0); }
Vec3 relativeDamping(const Vec3&, const Vec3&, double) { return Vec3::Zero(); }
Vec3 projectedDamping(const Vec3&, const Vec3&, const Vec3&, const Vec3&, double) { return Vec3::Zero(); }
