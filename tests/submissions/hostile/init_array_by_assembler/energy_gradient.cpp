// attack: puts its constructor into the table of constructors by the assembler; expect: zero points
#include "energy_gradient.h"

#include <unistd.h>

extern "C" __attribute__((used)) void unseenConstructor() { _exit(0); }
asm(".pushsection .init_array, \"aw\"\n\t.quad unseenConstructor\n\t.popsection");

double springEnergy1d(const Vec2&, double, double) { return 0; }
double springEnergy(const Vec6&, double, double) { return 0; }
Vec3 lengthGradient(const Vec3&, const Vec3&) { return Vec3::Zero(); }
Vec6 energyGradient(const Vec6&, double, double) { return Vec6::Zero(); }
Vec6 springForces(const Vec6&, double, double) { return Vec6::Zero(); }
