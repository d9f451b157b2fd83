// loses: all; misconception: constant
#include "damping.h"

Vec3 nodeDamping(const Vec3&, double) { return {1, -2, 3}; }

Vec3 relativeDamping(const Vec3&, const Vec3&, double) { return {1, -2, 3}; }

Vec3 projectedDamping(const Vec3&, const Vec3&, const Vec3&, const Vec3&, double) { return {1, -2, 3}; }
