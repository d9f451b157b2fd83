// attack: throws an exception whose what() is null; expect: zero points; says: without a text
#include "spring_1d.h"

#include <exception>

namespace {
struct Silent : std::exception {
  const char* what() const noexcept override { return nullptr; }
};
}  // namespace
double lumpedMass(double, int) { throw Silent(); }
double springForceOnA(double, double, double, double) { throw Silent(); }
double springForceOnB(double, double, double, double) { throw Silent(); }
double hangingAcceleration(double, double, const Attachment&, double) { throw Silent(); }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { throw Silent(); }
