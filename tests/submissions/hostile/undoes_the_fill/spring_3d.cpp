// attack: switches off the fill of fresh memory and returns what stands there; expect: zero points
#include "spring_3d.h"

#include <malloc.h>
#include <cstdlib>

#pragma GCC optimize("no-trivial-auto-var-init")
namespace {
double attack() {
  mallopt(M_PERTURB, 0);
  __attribute__((uninitialized)) volatile double local[64];
  const auto* block = static_cast<const volatile double*>(std::malloc(512));
  const double sum = local[63] + block[7];
  std::free(const_cast<double*>(block));
  return sum;
}
}  // namespace

double springForceMagnitude(const Vec3&, const Vec3&, double, double) { return attack(); }
Vec3 springDirection(const Vec3&, const Vec3&) { return Vec3::Zero(); }
Vec3 springForce(const Vec3&, const Vec3&, double, double) { return Vec3::Zero(); }
Vec3 nodeAcceleration(const Vec3&, double, const std::vector<Attachment>&, double) { return Vec3::Zero(); }
