// attack: throws an exception whose words are a megabyte; expect: zero points; says: threw an exception
#include "spring_1d.h"

#include <stdexcept>
#include <string>

namespace {
double attack() { throw std::runtime_error(std::string(1 << 20, 'x')); }
}  // namespace

double lumpedMass(double, int) { return attack(); }
double springForceOnA(double, double, double, double) { return attack(); }
double springForceOnB(double, double, double, double) { return attack(); }
double hangingAcceleration(double, double, const Attachment&, double) { return attack(); }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return attack(); }
