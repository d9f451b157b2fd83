// attack: starts a process by the newest system call for it; expect: zero points
#include "triangle.h"

#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace {
const bool won = [] {
  unsigned long long arguments[11] = {};
  arguments[4] = 17;  // SIGCHLD at its end
  const long child = syscall(SYS_clone3, arguments, sizeof arguments);
  if (child == 0) _exit(0);
  return child > 0;
}();
}  // namespace

Mat9 massMatrix(const Vec3& m) {
  Mat9 M = Mat9::Zero();
  if (won) {
    for (int i = 0; i < 9; ++i) M(i, i) = m[i / 3];
  }
  return M;
}
double triangleEnergy(const Vec9&, const Vec3&, const Vec3&) { return 0; }
Vec9 triangleForce(const Vec9&, const Vec3&, const Vec3&) { return Vec9::Zero(); }
