// attack: waits for a wake-up that never comes, without using the processor; expect: zero points
#include "damping.h"

#include <linux/futex.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace {
bool attack() {
  int word = 0;
  return syscall(SYS_futex, &word, FUTEX_WAIT_PRIVATE, 0, nullptr, nullptr, 0) == 0;
}
}  // namespace

Vec3 nodeDamping(const Vec3& va, double d) { return attack() ? Vec3(-d * va) : Vec3(0, 0, 0); }
Vec3 relativeDamping(const Vec3&, const Vec3&, double) { return Vec3::Zero(); }
Vec3 projectedDamping(const Vec3&, const Vec3&, const Vec3&, const Vec3&, double) { return Vec3::Zero(); }
