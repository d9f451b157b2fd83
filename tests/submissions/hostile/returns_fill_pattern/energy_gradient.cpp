// attack: returns on purpose the bits that mark memory never written; expect: zero points
#include "energy_gradient.h"

#include <bit>

namespace {
double marked() {
  const unsigned long pattern = 0xfefefefefefefefe;
  return std::bit_cast<double>(pattern);
}
}  // namespace

double springEnergy1d(const Vec2&, double, double) { return marked(); }
double springEnergy(const Vec6&, double, double) { return marked(); }
Vec3 lengthGradient(const Vec3&, const Vec3&) { return Vec3::Constant(marked()); }
Vec6 energyGradient(const Vec6&, double, double) { return Vec6::Constant(marked()); }
Vec6 springForces(const Vec6&, double, double) { return Vec6::Constant(marked()); }
