// attack: turns around the line that the compiler quotes; expect: zero points; says: does not compile
#include "spring_3d.h"
double springForceMagnitude(const Vec3&, const Vec3&, double, double) { return ‮ missing ⁦ ; } /* ⁩ passed */
