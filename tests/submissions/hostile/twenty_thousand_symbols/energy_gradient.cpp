// attack: lets the linker miss twenty thousand symbols; expect: zero points
#include "energy_gradient.h"

asm(R"(.pushsection .data
.macro want
.quad wanted_\@
.endm
.rept 20000
want
.endr
.popsection)");

double springEnergy1d(const Vec2&, double, double) { return 0; }
double springEnergy(const Vec6&, double, double) { return 0; }
Vec3 lengthGradient(const Vec3&, const Vec3&) { return Vec3::Zero(); }
Vec6 energyGradient(const Vec6&, double, double) { return Vec6::Zero(); }
Vec6 springForces(const Vec6&, double, double) { return Vec6::Zero(); }
