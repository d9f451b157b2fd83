// attack: spells a function with letters of another alphabet and a mark that turns the line around; expect: zero points
#include "energy_gradient.h"

double springЕnergy(const Vec6&, double, double) { return 0; }  // the E is Cyrillic
/* ‮ } ⁦ if (false) ⁩ ⁦ */

double springEnergy1d(const Vec2&, double, double) { return 0; }
Vec3 lengthGradient(const Vec3&, const Vec3&) { return Vec3::Zero(); }
Vec6 energyGradient(const Vec6&, double, double) { return Vec6::Zero(); }
Vec6 springForces(const Vec6&, double, double) { return Vec6::Zero(); }
