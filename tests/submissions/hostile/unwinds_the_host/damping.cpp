// attack: ends the thread of the host, and unwinds the host's own calls; expect: zero points
#include "damping.h"

#include <pthread.h>

namespace {
bool attack() { pthread_exit(nullptr); }
}  // namespace

Vec3 nodeDamping(const Vec3& va, double d) { return attack() ? Vec3(-d * va) : Vec3(0, 0, 0); }
Vec3 relativeDamping(const Vec3&, const Vec3&, double) { return Vec3::Zero(); }
Vec3 projectedDamping(const Vec3&, const Vec3&, const Vec3&, const Vec3&, double) { return Vec3::Zero(); }
