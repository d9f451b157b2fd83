// loses: CoincidentNodes; misconception: unguarded or missing_guard
#include "energy_gradient.h"

double springEnergy1d(const Vec2& x, double k, double L0) {
  const double L = std::abs(x[0] - x[1]);
  return 0.5 * k * (L - L0) * (L - L0);
}

double springEnergy(const Vec6& x, double k, double L0) {
  const double L = (x.head<3>() - x.tail<3>()).norm();
  return 0.5 * k * (L - L0) * (L - L0);
}

Vec3 lengthGradient(const Vec3& xa, const Vec3& xb) { return (xa - xb) / (xa - xb).norm(); }

Vec6 energyGradient(const Vec6& x, double k, double L0) {
  const Vec3 xa = x.head<3>(), xb = x.tail<3>();
  const double tension = k * ((xa - xb).norm() - L0);
  Vec6 result;
  result << tension * lengthGradient(xa, xb), tension * lengthGradient(xb, xa);
  return result;
}

Vec6 springForces(const Vec6& x, double k, double L0) { return -energyGradient(x, k, L0); }
