#include "energy_gradient.h"

static double elastic(double L, double k, double L0) {
  double s = L - L0;
  return 0.5 * k * s * s;
}

double springEnergy1d(const Vec2& x, double k, double L0) { return elastic(std::abs(x(1) - x(0)), k, L0); }

double springEnergy(const Vec6& x, double k, double L0) {
  return elastic((x.segment<3>(0) - x.segment<3>(3)).norm(), k, L0);
}

Vec3 lengthGradient(const Vec3& xa, const Vec3& xb) {
  Vec3 r = xa - xb;
  double L = r.norm();
  if (L == 0) return Vec3::Zero();
  r /= L;
  return r;
}

Vec6 energyGradient(const Vec6& x, double k, double L0) {
  Vec3 xa = x.segment<3>(0), xb = x.segment<3>(3);
  double dEdL = k * ((xa - xb).norm() - L0);
  Vec3 onA = dEdL * lengthGradient(xa, xb);
  Vec6 g;
  g << onA, -onA;
  return g;
}

Vec6 springForces(const Vec6& x, double k, double L0) {
  Vec6 F = energyGradient(x, k, L0);
  return -1.0 * F;
}
