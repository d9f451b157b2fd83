// attack: returns the smallest number; expect: zero points
#include "spring_1d.h"

double lumpedMass(double, int) { return 5e-324; }
double springForceOnA(double, double, double, double) { return 5e-324; }
double springForceOnB(double, double, double, double) { return 5e-324; }
double hangingAcceleration(double, double, const Attachment&, double) { return 5e-324; }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return 5e-324; }
