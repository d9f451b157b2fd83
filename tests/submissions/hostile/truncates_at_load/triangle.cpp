// attack: truncates, makes and names files from a constructor; expect: zero points
#include "triangle.h"

#include <fcntl.h>

namespace {
const bool won = [] {
  bool opened = false;
  for (const char* name : {"/tmp/dropped", "/dropped", "/dev/shm/dropped", "/var/tmp/dropped"}) {
    opened = open(name, O_WRONLY | O_TRUNC | O_CREAT, 0666) >= 0 || opened;
  }
  for (const char* folder : {"/tmp", "/var/tmp", "/dev/shm", "."}) {
    opened = open(folder, O_TMPFILE | O_RDWR, 0600) >= 0 || opened;
  }
  return opened;
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
