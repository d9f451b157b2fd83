// attack: leaves a function of the contract as a weak symbol that nobody defines; expect: zero points
#include "triangle.h"

extern "C" double nowhere() __attribute__((weak));

Mat9 massMatrix(const Vec3&) { return Mat9::Constant(nowhere()); }
__attribute__((weak)) double triangleEnergy(const Vec9&, const Vec3&, const Vec3&);
__attribute__((weak)) Vec9 triangleForce(const Vec9&, const Vec3&, const Vec3&);
