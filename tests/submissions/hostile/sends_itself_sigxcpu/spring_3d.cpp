// attack: sends itself the signal of the limit of CPU time; expect: zero points
#include "spring_3d.h"

#include <sys/syscall.h>
#include <unistd.h>
#include <csignal>

namespace {
bool attack() {
  syscall(SYS_tgkill, getpid(), getpid(), SIGXCPU);
  return false;
}
}  // namespace

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return attack() ? -k * ((xa - xb).norm() - L0) : 0;
}
Vec3 springDirection(const Vec3&, const Vec3&) { return Vec3::Zero(); }
Vec3 springForce(const Vec3&, const Vec3&, double, double) { return Vec3::Zero(); }
Vec3 nodeAcceleration(const Vec3&, double, const std::vector<Attachment>&, double) { return Vec3::Zero(); }
