// attack: sets rounding, flushing to zero and the precision of the processor for the calls that follow; expect: zero points
#include "damping.h"

#include <xmmintrin.h>
#include <cfenv>

namespace {
bool attack() {
  std::fesetround(FE_UPWARD);
  _mm_setcsr(_mm_getcsr() | 0x8040);
  const unsigned short single = 0x007f;
  asm volatile("fldcw %0" : : "m"(single));
  return false;
}
}  // namespace

Vec3 nodeDamping(const Vec3& va, double d) { return attack() ? Vec3(-d * va) : Vec3(0, 0, 0); }
Vec3 relativeDamping(const Vec3&, const Vec3&, double) { return Vec3::Zero(); }
Vec3 projectedDamping(const Vec3&, const Vec3&, const Vec3&, const Vec3&, double) { return Vec3::Zero(); }
