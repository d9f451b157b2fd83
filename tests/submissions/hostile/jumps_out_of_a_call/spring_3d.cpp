// attack: jumps out of a call into a frame that is gone; expect: zero points
#include "spring_3d.h"

#include <csetjmp>

namespace {
std::jmp_buf place;
const int returned = setjmp(place);

bool attack() {
  if (returned == 0) std::longjmp(place, 1);
  return true;
}
}  // namespace

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return attack() ? -k * ((xa - xb).norm() - L0) : 0;
}
Vec3 springDirection(const Vec3&, const Vec3&) { return Vec3::Zero(); }
Vec3 springForce(const Vec3&, const Vec3&, double, double) { return Vec3::Zero(); }
Vec3 nodeAcceleration(const Vec3&, double, const std::vector<Attachment>&, double) { return Vec3::Zero(); }
