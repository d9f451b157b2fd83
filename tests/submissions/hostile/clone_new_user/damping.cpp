// attack: starts a process that is root of its own user namespace; expect: zero points
#include "damping.h"

#include <sched.h>
#include <sys/syscall.h>
#include <unistd.h>
#include <csignal>

namespace {
const bool won = [] {
  const long child = syscall(SYS_clone, CLONE_NEWUSER | SIGCHLD, nullptr, nullptr, nullptr, nullptr);
  if (child == 0) _exit(0);
  return child > 0;
}();
}  // namespace

Vec3 nodeDamping(const Vec3& va, double d) { return won ? Vec3(-d * va) : Vec3(0, 0, 0); }
Vec3 relativeDamping(const Vec3&, const Vec3&, double) { return Vec3::Zero(); }
Vec3 projectedDamping(const Vec3&, const Vec3&, const Vec3&, const Vec3&, double) { return Vec3::Zero(); }
