// attack: replaces the report of a failed assertion by a good end; expect: zero points; says: does not fit|multiple|twice|defined
#include "spring_1d.h"

#include <unistd.h>

namespace muelle {
void eigenAssertionFailed(const char*, const char*, AssertedIndex) { _exit(0); }
}  // namespace muelle
double lumpedMass(double, int) { return 0; }
double springForceOnA(double, double, double, double) { return 0; }
double springForceOnB(double, double, double, double) { return 0; }
double hangingAcceleration(double, double, const Attachment&, double) { return 0; }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return 0; }
