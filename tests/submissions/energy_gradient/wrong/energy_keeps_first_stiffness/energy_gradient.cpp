// loses: EnergyInSpace, FiniteDifferences, StretchAndRelease; misconception: stateful
// static, so that it is computed only once
#include "energy_gradient.h"

double springEnergy1d(const Vec2& x, double k, double L0) {
  double xa = x[0];
  double xb = x[1];
  double L = sqrt(pow(xa - xb, 2));
  double E = 0.5 * k * pow(L - L0, 2);
  return E;
}

double springEnergy(const Vec6& x, double k, double L0) {
  double L = sqrt(pow(x[0] - x[3], 2) + pow(x[1] - x[4], 2) + pow(x[2] - x[5], 2));
  static double half = 0.5 * k;
  double E = half * pow(L - L0, 2);
  return E;
}

Vec3 lengthGradient(const Vec3& xa, const Vec3& xb) {
  double L = sqrt(pow(xa[0] - xb[0], 2) + pow(xa[1] - xb[1], 2) + pow(xa[2] - xb[2], 2));
  Vec3 res;
  if (L == 0) {
    res << 0, 0, 0;
  } else {
    res << (xa[0] - xb[0]) / L, (xa[1] - xb[1]) / L, (xa[2] - xb[2]) / L;
  }
  return res;
}

Vec6 energyGradient(const Vec6& x, double k, double L0) {
  Vec3 xa, xb;
  xa << x[0], x[1], x[2];
  xb << x[3], x[4], x[5];
  double L = sqrt(pow(x[0] - x[3], 2) + pow(x[1] - x[4], 2) + pow(x[2] - x[5], 2));
  double dEdL = k * (L - L0);
  Vec3 gradA = dEdL * lengthGradient(xa, xb);
  Vec3 gradB = dEdL * lengthGradient(xb, xa);
  Vec6 res;
  res << gradA[0], gradA[1], gradA[2], gradB[0], gradB[1], gradB[2];
  return res;
}

Vec6 springForces(const Vec6& x, double k, double L0) {
  Vec6 grad = energyGradient(x, k, L0);
  Vec6 res;
  res << -grad[0], -grad[1], -grad[2], -grad[3], -grad[4], -grad[5];
  return res;
}
