// loses: all; misconception: zero
#include "damping.h"

Vec3 nodeDamping(const Vec3&, double) { return Vec3::Zero(); }

Vec3 relativeDamping(const Vec3&, const Vec3&, double) { return Vec3::Zero(); }

Vec3 projectedDamping(const Vec3&, const Vec3&, const Vec3&, const Vec3&, double) { return Vec3::Zero(); }
