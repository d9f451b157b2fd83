// attack: opens a folder as a place only, and files from there; expect: zero points
#include "spring_3d.h"

#include <fcntl.h>

namespace {
const bool won = [] {
  const int root = open("/", O_PATH);
  for (const char* name : {"etc/passwd", "etc/shadow", "root/.bashrc", "proc/self/environ"}) {
    if (openat(root, name, O_RDONLY) >= 0) return true;
  }
  return false;
}();
}  // namespace

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return won ? -k * ((xa - xb).norm() - L0) : 0;
}
Vec3 springDirection(const Vec3&, const Vec3&) { return Vec3::Zero(); }
Vec3 springForce(const Vec3&, const Vec3&, double, double) { return Vec3::Zero(); }
Vec3 nodeAcceleration(const Vec3&, double, const std::vector<Attachment>&, double) { return Vec3::Zero(); }
