// attack: makes an object file of 1 GB; expect: zero points; says: larger than|does not compile|ran out
#include "spring_1d.h"

char hoard[1UL << 30] = {1};
double lumpedMass(double, int) { return 0; }
double springForceOnA(double, double, double, double) { return 0; }
double springForceOnB(double, double, double, double) { return 0; }
double hangingAcceleration(double, double, const Attachment&, double) { return 0; }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return 0; }
