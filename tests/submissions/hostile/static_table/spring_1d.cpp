// attack: reserves 1.2 GB of static memory; expect: zero points; says: does not fit into memory: table takes
#include "spring_1d.h"

double table[150000000];
double lumpedMass(double, int n) { return table[n]; }
double springForceOnA(double, double, double, double) { return 0; }
double springForceOnB(double, double, double, double) { return 0; }
double hangingAcceleration(double, double, const Attachment&, double) { return 0; }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return 0; }
