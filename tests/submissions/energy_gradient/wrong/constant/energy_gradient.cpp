// loses: all; misconception: constant
#include "energy_gradient.h"

double springEnergy1d(const Vec2&, double, double) { return 7.5; }
double springEnergy(const Vec6&, double, double) { return 20.0; }
Vec3 lengthGradient(const Vec3&, const Vec3&) { return Vec3(0.6, 0.0, 0.8); }
Vec6 energyGradient(const Vec6&, double, double) { return (Vec6() << 12, 0, 16, -12, 0, -16).finished(); }
Vec6 springForces(const Vec6&, double, double) { return (Vec6() << -12, 0, -16, 12, 0, 16).finished(); }
