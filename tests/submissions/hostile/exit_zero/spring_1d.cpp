// attack: ends the program with success; expect: zero points; says: ended the program with exit\(0\)
#include "spring_1d.h"

#include <cstdlib>

namespace {
double attack() { std::exit(0); }
}  // namespace

double lumpedMass(double, int) { return attack(); }
double springForceOnA(double, double, double, double) { return attack(); }
double springForceOnB(double, double, double, double) { return attack(); }
double hangingAcceleration(double, double, const Attachment&, double) { return attack(); }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return attack(); }
