#include "energy_gradient.h"

#include <Eigen/Dense>

using Eigen::Vector3d;

static double energyOf(double L, double k, double L0) {
  const double s = L - L0;
  return k * s * s / 2.0;
}

double springEnergy1d(const Vec2& x, double k, double L0) { return energyOf(std::fabs(x[1] - x[0]), k, L0); }

double springEnergy(const Vec6& x, double k, double L0) { return energyOf((x.head(3) - x.tail(3)).norm(), k, L0); }

// normalized() of the zero vector is the zero vector
Vec3 lengthGradient(const Vec3& xa, const Vec3& xb) { return (xa - xb).normalized(); }

Vec6 springForces(const Vec6& x, double k, double L0) {
  const Vector3d d = x.tail<3>() - x.head<3>();  // from a to b
  const Vector3d pull = k * (d.norm() - L0) * d.normalized();
  return (Vec6() << pull, -pull).finished();
}

Vec6 energyGradient(const Vec6& x, double k, double L0) { return springForces(x, k, L0) * -1.0; }
