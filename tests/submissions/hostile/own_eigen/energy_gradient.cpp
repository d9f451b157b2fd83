// attack: stands in for the headers of the harness by their guards; expect: zero points
#define EIGEN_CORE_H
#define EIGEN_CORE_MODULE_H
#define EIGEN_NO_AUTOMATIC_RESIZING
#define EIGEN_INITIALIZE_MATRICES_BY_ZERO
#define eigen_assert(condition)
#include "energy_gradient.h"

double springEnergy1d(const Vec2&, double, double) { return Vec2()[0]; }
double springEnergy(const Vec6&, double, double) { return Vec6()[5]; }
Vec3 lengthGradient(const Vec3&, const Vec3&) { return Vec3(); }
Vec6 energyGradient(const Vec6&, double, double) { return Vec6(); }
Vec6 springForces(const Vec6&, double, double) { return Vec6(); }
