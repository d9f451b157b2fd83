// attack: allocates until nothing is left; expect: zero points; says: abort|did not return
#include "spring_1d.h"

#include <cstdlib>

namespace {
double attack() {
  for (long i = 0;; ++i) {
    char* block = static_cast<char*>(std::malloc(1 << 24));
    if (block == nullptr) std::abort();
    for (int j = 0; j < 1 << 24; j += 4096) block[j] = 1;
  }
}
}  // namespace

double lumpedMass(double, int) { return attack(); }
double springForceOnA(double, double, double, double) { return attack(); }
double springForceOnB(double, double, double, double) { return attack(); }
double hangingAcceleration(double, double, const Attachment&, double) { return attack(); }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return attack(); }
