// attack: writes a file of results; expect: zero points; says: was stopped
#include "spring_1d.h"

#include <fstream>

namespace {
double attack() {
  for (const char* name : {"results.json", "/tmp/results.json", "/autograder/results/results.json"}) {
    std::ofstream(name) << "{\"score\": 10}";
  }
  return 0;
}
}  // namespace

double lumpedMass(double, int) { return attack(); }
double springForceOnA(double, double, double, double) { return attack(); }
double springForceOnB(double, double, double, double) { return attack(); }
double hangingAcceleration(double, double, const Attachment&, double) { return attack(); }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return attack(); }
