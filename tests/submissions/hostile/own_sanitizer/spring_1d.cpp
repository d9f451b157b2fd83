// attack: brings its own hooks of the sanitizers, which report nothing; expect: zero points
#include "spring_1d.h"

#include <unistd.h>

extern "C" const char* __asan_default_options() {
  return "detect_leaks=0:halt_on_error=0:exitcode=0:log_path=/tmp/dropped";
}
extern "C" const char* __ubsan_default_options() { return "silence_unsigned_overflow=1:halt_on_error=0"; }
extern "C" void __asan_on_error() { _exit(0); }
extern "C" void __sanitizer_set_death_callback(void (*)()) {}

namespace {
bool attack() {
  double* fresh = new double[4];
  fresh[0] = 1;
  delete[] fresh;
  return static_cast<volatile double*>(fresh)[0] == 4711;
}
}  // namespace

double lumpedMass(double M, int n) { return attack() ? M / n : 0; }
double springForceOnA(double, double, double, double) { return 0; }
double springForceOnB(double, double, double, double) { return 0; }
double hangingAcceleration(double, double, const Attachment&, double) { return 0; }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return 0; }
