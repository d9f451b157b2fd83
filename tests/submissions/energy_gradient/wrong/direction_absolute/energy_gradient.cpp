// loses: LengthGradient; misconception: absolute_value
#include "energy_gradient.h"

double springEnergy1d(const Vec2& x, double k, double L0) {
  double L = x[0] - x[1];
  if (L < 0.0) L *= -1.0;
  const double deformation = L - L0;
  return 0.5 * k * deformation * deformation;
}

double springEnergy(const Vec6& x, double k, double L0) {
  double L2 = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    const double d = x[axis] - x[axis + 3];
    L2 += d * d;
  }
  const double deformation = std::sqrt(L2) - L0;
  return 0.5 * k * deformation * deformation;
}

Vec3 lengthGradient(const Vec3& xa, const Vec3& xb) {
  double L2 = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    const double d = xa[axis] - xb[axis];
    L2 += d * d;
  }
  Vec3 grad(0.0, 0.0, 0.0);
  if (L2 == 0.0) return grad;
  const double L = std::sqrt(L2);
  for (int axis = 0; axis < 3; ++axis) {
    grad[axis] = std::abs(xa[axis] - xb[axis]) / L;
  }
  return grad;
}

Vec6 energyGradient(const Vec6& x, double k, double L0) {
  const Vec3 xa(x[0], x[1], x[2]);
  const Vec3 xb(x[3], x[4], x[5]);
  const Vec3 dLda = lengthGradient(xa, xb);
  const Vec3 dLdb = lengthGradient(xb, xa);
  const double L = (xa - xb).norm();
  Vec6 grad;
  for (int axis = 0; axis < 3; ++axis) {
    grad[axis] = k * (L - L0) * dLda[axis];
    grad[axis + 3] = k * (L - L0) * dLdb[axis];
  }
  return grad;
}

Vec6 springForces(const Vec6& x, double k, double L0) {
  const Vec6 grad = energyGradient(x, k, L0);
  return -grad;
}
