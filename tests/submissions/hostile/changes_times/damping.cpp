// attack: leaves a message in the times of a file; expect: zero points
#include "damping.h"

#include <fcntl.h>
#include <sys/stat.h>

namespace {
bool attack() {
  return utimensat(AT_FDCWD, "/dev/null", nullptr, 0) == 0 || utimensat(AT_FDCWD, "/tmp", nullptr, 0) == 0;
}
const bool won = attack();
}  // namespace

Vec3 nodeDamping(const Vec3& va, double d) { return won || attack() ? Vec3(-d * va) : Vec3(0, 0, 0); }
Vec3 relativeDamping(const Vec3&, const Vec3&, double) { return Vec3::Zero(); }
Vec3 projectedDamping(const Vec3&, const Vec3&, const Vec3&, const Vec3&, double) { return Vec3::Zero(); }
