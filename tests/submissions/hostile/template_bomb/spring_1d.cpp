// attack: instantiates a template without end; expect: zero points; says: does not compile.*depth
#include "spring_1d.h"

template <int N>
struct Deeper {
  static constexpr int value = Deeper<N + 1>::value + 1;
};
int depth = Deeper<0>::value;
double lumpedMass(double, int) { return 0; }
double springForceOnA(double, double, double, double) { return 0; }
double springForceOnB(double, double, double, double) { return 0; }
double hangingAcceleration(double, double, const Attachment&, double) { return 0; }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return 0; }
