// attack: prints a verdict and ends well when its thread ends; expect: zero points
#include "spring_1d.h"

#include <unistd.h>
#include <cstdio>
#include <cstdlib>

namespace {
struct AtEnd {
  bool touched = false;
  ~AtEnd() {
    std::puts("[  PASSED  ] 10 tests.");
    std::fflush(stdout);
    _exit(0);
  }
};
thread_local AtEnd atEnd;

bool attack() {
  atEnd.touched = true;
  std::exit(0);
}
}  // namespace

double lumpedMass(double M, int n) { return attack() ? M / n : 0; }
double springForceOnA(double, double, double, double) { return 0; }
double springForceOnB(double, double, double, double) { return 0; }
double hangingAcceleration(double, double, const Attachment&, double) { return 0; }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return 0; }
