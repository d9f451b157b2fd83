// attack: uses a library that this machine happens to have; expect: zero points; says: reads fmt/format.h|No such file
#include <fmt/format.h>

#include "spring_1d.h"

double lumpedMass(double, int) { return static_cast<double>(fmt::formatted_size("{}", 1)) - 1; }
double springForceOnA(double, double, double, double) { return 0; }
double springForceOnB(double, double, double, double) { return 0; }
double hangingAcceleration(double, double, const Attachment&, double) { return 0; }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return 0; }
