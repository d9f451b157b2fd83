// attack: includes the memory map of the compiler; expect: zero points; says: does not compile.*(No such file|Permission denied|cannot open)
#include "spring_1d.h"

#include "/proc/self/maps"
double lumpedMass(double, int) { return 0; }
double springForceOnA(double, double, double, double) { return 0; }
double springForceOnB(double, double, double, double) { return 0; }
double hangingAcceleration(double, double, const Attachment&, double) { return 0; }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return 0; }
