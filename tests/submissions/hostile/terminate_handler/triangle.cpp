// attack: ends well when an exception meets a function that throws none; expect: zero points
#include "triangle.h"

#include <unistd.h>
#include <exception>

namespace {
void leave() noexcept(false) { throw 1; }

bool attack() noexcept {
  std::set_terminate([] { _exit(0); });
  leave();
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
