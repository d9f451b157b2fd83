// attack: lets the linker quote a symbol that says the linker was killed; expect: zero points
#include "spring_1d.h"

asm(".pushsection .data\n\t.quad \"collect2: fatal error: ld terminated with signal 9 [Killed]\"\n\t.popsection");

double lumpedMass(double, int) { return 0; }
double springForceOnA(double, double, double, double) { return 0; }
double springForceOnB(double, double, double, double) { return 0; }
double hangingAcceleration(double, double, const Attachment&, double) { return 0; }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return 0; }
