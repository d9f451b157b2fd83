// loses: all; misconception: constant
#include "spring_1d.h"

double lumpedMass(double, int) { return 1.5; }
double springForceOnA(double, double, double, double) { return -7; }
double springForceOnB(double, double, double, double) { return 7; }
double hangingAcceleration(double, double, const Attachment&, double) { return -9.81; }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return -9.81; }
