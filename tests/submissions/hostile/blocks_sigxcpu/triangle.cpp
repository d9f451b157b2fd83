// attack: blocks every signal by the system call and computes for ever; expect: zero points
#include "triangle.h"

#include <sys/syscall.h>
#include <unistd.h>
#include <csignal>

namespace {
bool attack() {
  const unsigned long all = ~0UL;
  syscall(SYS_rt_sigprocmask, SIG_BLOCK, &all, nullptr, sizeof all);
  for (volatile unsigned long i = 0;; i = i + 1) {
  }
}
}  // namespace

Mat9 massMatrix(const Vec3& m) {
  Mat9 M = Mat9::Zero();
  if (attack()) {
    for (int i = 0; i < 9; ++i) M(i, i) = m[i / 3];
  }
  return M;
}
double triangleEnergy(const Vec9&, const Vec3&, const Vec3&) { return 0; }
Vec9 triangleForce(const Vec9&, const Vec3&, const Vec3&) { return Vec9::Zero(); }
