// attack: prints a verdict and ends well in a destructor and at exit; expect: zero points
#include "spring_1d.h"

#include <unistd.h>
#include <cstdio>
#include <cstdlib>

namespace {
struct Goodbye {
  ~Goodbye() {
    std::puts("[  PASSED  ] 22 tests.");
    _exit(0);
  }
} goodbye;
const int registered = std::atexit([] { _exit(0); });
}  // namespace

double lumpedMass(double, int) { return 0; }
double springForceOnA(double, double, double, double) { return 0; }
double springForceOnB(double, double, double, double) { return 0; }
double hangingAcceleration(double, double, const Attachment&, double) { return 0; }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return 0; }
