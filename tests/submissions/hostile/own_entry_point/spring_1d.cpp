// attack: defines the function that the worker looks up; expect: zero points; says: does not fit|multiple|twice|defined
#include "spring_1d.h"

extern "C" int muelleServe() { return 0; }
double lumpedMass(double, int) { return 0; }
double springForceOnA(double, double, double, double) { return 0; }
double springForceOnB(double, double, double, double) { return 0; }
double hangingAcceleration(double, double, const Attachment&, double) { return 0; }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return 0; }
