// attack: makes folders and links, renames and removes from a constructor; expect: zero points
#include "spring_1d.h"

#include <sys/stat.h>
#include <unistd.h>
#include <cstdio>

namespace {
const bool won = [] {
  const bool made = mkdir("/tmp/dropped", 0777) == 0 || symlink("/etc/passwd", "/var/tmp/dropped") == 0;
  return rename("/submission.so", "/dropped") == 0 || unlink("/submission.so") == 0 || rmdir("/tmp/dropped") == 0 ||
         made;
}();
}  // namespace

double lumpedMass(double M, int n) { return won ? M / n : 0; }
double springForceOnA(double, double, double, double) { return 0; }
double springForceOnB(double, double, double, double) { return 0; }
double hangingAcceleration(double, double, const Attachment&, double) { return 0; }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return 0; }
