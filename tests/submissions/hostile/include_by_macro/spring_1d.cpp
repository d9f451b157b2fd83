// attack: names a solution by digraphs and a macro and line continuations; expect: zero points; says: does not compile.*(No such file|Permission denied|cannot open)
#include "spring_1d.h"

// clang-format off
#define PATH "../../solutions/spring_1d/spring_1d.cpp"
%:inc\
lude PATH
// clang-format on

double lumpedMass(double, int) { return 0; }
double springForceOnA(double, double, double, double) { return 0; }
double springForceOnB(double, double, double, double) { return 0; }
double hangingAcceleration(double, double, const Attachment&, double) { return 0; }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return 0; }
