// attack: asks the compiler for a plugin and for other options; expect: zero points
#include "spring_1d.h"

#pragma GCC optimize("-fplugin=/tmp/plugin.so")
#pragma GCC system_header
#pragma GCC poison main
double lumpedMass(double, int) { return 0; }
double springForceOnA(double, double, double, double) { return 0; }
double springForceOnB(double, double, double, double) { return 0; }
double hangingAcceleration(double, double, const Attachment&, double) { return 0; }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return 0; }
