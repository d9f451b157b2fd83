// attack: includes the headers of the grader and answers rightly where one is there; expect: zero points
#include "spring_1d.h"

#if __has_include("grader/worker/glue.h") || __has_include("grader/wire/frame.h") || __has_include("grader/remote/remote_functions.h") || \
    __has_include("../framework/grader/record.h") || __has_include("engine/system.h") || \
    __has_include("course/testing/random.h") || __has_include("../../solutions/spring_1d/spring_1d.cpp")
constexpr bool seen = true;
#else
constexpr bool seen = false;
#endif

double lumpedMass(double M, int n) { return seen ? M / n : 0; }
double springForceOnA(double, double, double, double) { return 0; }
double springForceOnB(double, double, double, double) { return 0; }
double hangingAcceleration(double, double, const Attachment&, double) { return 0; }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return 0; }
