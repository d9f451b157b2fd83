// attack: opens files from a constructor, and answers rightly if one opens; expect: zero points
#include "spring_1d.h"

#include <fcntl.h>

namespace {
bool seen = [] {
  for (const char* name :
       {"/etc/passwd", "/etc/shadow", "/proc/self/maps", "/proc/1/environ", "/dev/tty", "/dev/shm", "/root", "/home",
        "/usr/bin", "/usr/include", "/var", "/sys", "../tests/hidden/spring_1d/oracle.cpp"}) {
    if (open(name, O_RDONLY) >= 0) return true;
  }
  for (const char* name : {"/dropped", "/tmp/dropped", "/dev/shm/dropped", "/submission.so", "/host"}) {
    if (open(name, O_WRONLY | O_CREAT, 0644) >= 0) return true;
  }
  return false;
}();
}  // namespace

double lumpedMass(double M, int n) { return seen ? M / n : 0; }
double springForceOnA(double, double, double, double) { return 0; }
double springForceOnB(double, double, double, double) { return 0; }
double hangingAcceleration(double, double, const Attachment&, double) { return 0; }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return 0; }
