// attack: changes the contract by macros that stand before it; expect: zero points
#define MUELLE_FUNCTIONS(...)
#define MUELLE_STRUCT(...)
#define springForce someOtherForce
#define private public
#include "spring_3d.h"
#undef springForce

double springForceMagnitude(const Vec3&, const Vec3&, double, double) { return 0; }
Vec3 springDirection(const Vec3&, const Vec3&) { return Vec3::Zero(); }
Vec3 nodeAcceleration(const Vec3&, double, const std::vector<Attachment>&, double) { return Vec3::Zero(); }
