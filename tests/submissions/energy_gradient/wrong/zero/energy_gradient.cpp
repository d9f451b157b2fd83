// loses: all; misconception: zero
#include "energy_gradient.h"

double springEnergy1d(const Vec2& x, double k, double L0) {
  (void)x, (void)k, (void)L0;
  return 0.0;
}

double springEnergy(const Vec6& x, double k, double L0) {
  (void)x, (void)k, (void)L0;
  return 0.0;
}

Vec3 lengthGradient(const Vec3& xa, const Vec3& xb) {
  (void)xa, (void)xb;
  return Vec3::Zero();
}

Vec6 energyGradient(const Vec6& x, double k, double L0) {
  (void)x, (void)k, (void)L0;
  return Vec6::Zero();
}

Vec6 springForces(const Vec6& x, double k, double L0) {
  (void)x, (void)k, (void)L0;
  return Vec6::Zero();
}
