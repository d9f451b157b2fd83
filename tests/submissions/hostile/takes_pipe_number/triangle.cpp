// attack: closes the pipe of answers and opens something else under its number; expect: zero points
#include "triangle.h"

#include <fcntl.h>
#include <unistd.h>

namespace {
const bool taken = [] {
  close(4);
  open("/submission.so", O_RDONLY);
  return true;
}();
}  // namespace

Mat9 massMatrix(const Vec3& m) {
  Mat9 M = Mat9::Zero();
  if (!taken) {
    for (int i = 0; i < 9; ++i) M(i, i) = m[i / 3];
  }
  return M;
}
double triangleEnergy(const Vec9&, const Vec3&, const Vec3&) { return 0; }
Vec9 triangleForce(const Vec9&, const Vec3&, const Vec3&) { return Vec9::Zero(); }
