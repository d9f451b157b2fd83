// loses: all; misconception: constant
#include "spring_3d.h"

double springForceMagnitude(const Vec3&, const Vec3&, double, double) { return -4.0; }
Vec3 springDirection(const Vec3&, const Vec3&) { return Vec3(0, 0, 1); }
Vec3 springForce(const Vec3&, const Vec3&, double, double) { return Vec3(1, 2, -3); }
Vec3 nodeAcceleration(const Vec3&, double, const std::vector<Attachment>&, double) { return Vec3(0, 0, -9.81); }
