// attack: keeps a function in a header beside the file; expect: zero points; says: helpers.h: No such file
#include "spring_1d.h"

#include "helpers.h"

double lumpedMass(double M, int n) { return share(M, n); }
double springForceOnA(double, double, double, double) { return 0; }
double springForceOnB(double, double, double, double) { return 0; }
double hangingAcceleration(double, double, const Attachment&, double) { return 0; }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return 0; }
