// attack: runs machine code that it keeps among the code as data; expect: zero points
#include "spring_3d.h"

namespace {
__attribute__((section(".text"), used, aligned(16)))
const unsigned char asksForParent[] = {0xb8, 110, 0, 0, 0, 0x0f, 0x05, 0xc3};

bool attack() { return reinterpret_cast<long (*)()>(reinterpret_cast<unsigned long>(&asksForParent[0]))() >= 0; }
}  // namespace

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return attack() ? -k * ((xa - xb).norm() - L0) : 0;
}
Vec3 springDirection(const Vec3&, const Vec3&) { return Vec3::Zero(); }
Vec3 springForce(const Vec3&, const Vec3&, double, double) { return Vec3::Zero(); }
Vec3 nodeAcceleration(const Vec3&, double, const std::vector<Attachment>&, double) { return Vec3::Zero(); }
