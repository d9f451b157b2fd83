// attack: opens a ring of requests that no filter sees; expect: zero points
#include "spring_3d.h"

#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace {
const bool won = [] {
  char parameters[256] = {};
  return syscall(SYS_io_uring_setup, 8, parameters) >= 0;
}();
}  // namespace

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return won ? -k * ((xa - xb).norm() - L0) : 0;
}
Vec3 springDirection(const Vec3&, const Vec3&) { return Vec3::Zero(); }
Vec3 springForce(const Vec3&, const Vec3&, double, double) { return Vec3::Zero(); }
Vec3 nodeAcceleration(const Vec3&, double, const std::vector<Attachment>&, double) { return Vec3::Zero(); }
