// attack: fills a disk with a constant of 200 MB; expect: zero points; says: larger than 64 MiB
#include "spring_1d.h"

extern const char large[200000000] = {1};
double lumpedMass(double, int n) { return large[n]; }
double springForceOnA(double, double, double, double) { return 0; }
double springForceOnB(double, double, double, double) { return 0; }
double hangingAcceleration(double, double, const Attachment&, double) { return 0; }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return 0; }
