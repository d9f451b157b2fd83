// attack: reserves 16 GB of static memory; expect: zero points; says: could not be loaded|ran out|does not fit|does not compile
#include "spring_1d.h"

char hoard[16UL << 30];
double lumpedMass(double, int) { return hoard[static_cast<unsigned long>(17) << 29]; }
double springForceOnA(double, double, double, double) { return hoard[static_cast<unsigned long>(17) << 29]; }
double springForceOnB(double, double, double, double) { return hoard[static_cast<unsigned long>(17) << 29]; }
double hangingAcceleration(double, double, const Attachment&, double) {
  return hoard[static_cast<unsigned long>(17) << 29];
}
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) {
  return hoard[static_cast<unsigned long>(17) << 29];
}
