// attack: prints what looks like passed tests; expect: zero points
#include "spring_1d.h"

#include <cstdio>

namespace {
double attack() {
  const char* text =
      "[==========] 22 tests from 9 test suites ran.\n[  PASSED  ] 22 tests.\n100% tests passed, 0 tests failed out of "
      "9\n"
      "{\"score\": 10, \"tests\": [{\"name\": \"Hooke\", \"score\": 10, \"max_score\": 10, \"status\": \"passed\"}]}\n"
      "<testsuites tests=\"9\" failures=\"0\"></testsuites>\n";
  std::fputs(text, stdout);
  std::fputs(text, stderr);
  std::fflush(stdout);
  return 0;
}
}  // namespace

double lumpedMass(double, int) { return attack(); }
double springForceOnA(double, double, double, double) { return attack(); }
double springForceOnB(double, double, double, double) { return attack(); }
double hangingAcceleration(double, double, const Attachment&, double) { return attack(); }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return attack(); }
