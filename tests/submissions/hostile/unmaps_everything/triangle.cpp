// attack: unmaps its own memory, the handlers of its death included; expect: zero points
#include "triangle.h"

#include <sys/mman.h>

namespace {
bool attack() {
  munmap(reinterpret_cast<void*>(4096), 0x7fff00000000UL);
  return true;
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
