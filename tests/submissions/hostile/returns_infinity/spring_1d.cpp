// attack: returns infinities; expect: zero points
#include "spring_1d.h"

double lumpedMass(double, int) { return INFINITY; }
double springForceOnA(double, double, double, double) { return INFINITY; }
double springForceOnB(double, double, double, double) { return INFINITY; }
double hangingAcceleration(double, double, const Attachment&, double) { return INFINITY; }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return INFINITY; }
