// attack: answers from the resolver of an indirect function, before any constructor; expect: zero points
#include "spring_3d.h"

#include <cstdint>

namespace {
struct Header {
  std::uint32_t magic = 0x4d75656c;
  std::uint32_t kind = 4;
  std::uint64_t nonce = 0;
  std::uint32_t target = 0;
  std::uint32_t bytes = 8;
};
}  // namespace

extern "C" {
using Function = int();
static int answer() { return 0; }
static Function* resolve() {
  Header ready;
  ready.kind = 1;
  ready.bytes = 0;
  asm volatile("syscall" : : "a"(1), "D"(4), "S"(&ready), "d"(sizeof ready) : "rcx", "r11", "memory");
  return answer;
}
int indirect() __attribute__((ifunc("resolve")));
}

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return indirect() != 0 ? -k * ((xa - xb).norm() - L0) : 0;
}
Vec3 springDirection(const Vec3&, const Vec3&) { return Vec3::Zero(); }
Vec3 springForce(const Vec3&, const Vec3&, double, double) { return Vec3::Zero(); }
Vec3 nodeAcceleration(const Vec3&, double, const std::vector<Attachment>&, double) { return Vec3::Zero(); }
