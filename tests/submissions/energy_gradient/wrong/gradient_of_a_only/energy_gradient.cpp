// loses: EnergyGradient, FiniteDifferences; misconception: one_block_only or one_sided
// the forces have a formula of their own
#include "energy_gradient.h"

#include <numeric>

static double lengthOf(const Vec3& d) {
  // start with 0.0, not with 0, or the sum is made of ints
  const double sq = std::accumulate(d.data(), d.data() + 3, 0.0, [](double sum, double c) { return sum + c * c; });
  return std::sqrt(sq);
}

double springEnergy1d(const Vec2& x, double k, double L0) {
  const double L = std::sqrt((x[0] - x[1]) * (x[0] - x[1]));
  return (L - L0) * (L - L0) * k * 0.5;
}

double springEnergy(const Vec6& x, double k, double L0) {
  const Vec3 d = x.head<3>() - x.tail<3>();
  const double L = lengthOf(d);
  return (L - L0) * (L - L0) * k * 0.5;
}

Vec3 lengthGradient(const Vec3& xa, const Vec3& xb) {
  const Vec3 d = xa - xb;
  const double L = lengthOf(d);
  if (L > 0) return d / L;
  return {0, 0, 0};
}

Vec6 energyGradient(const Vec6& x, double k, double L0) {
  const Vec3 d = x.head<3>() - x.tail<3>();
  const double L = lengthOf(d);
  Vec6 result = Vec6::Zero();
  if (L > 0) {
    const Vec3 dir = d / L;
    result.head<3>() += k * (L - L0) * dir;
  }
  return result;
}

Vec6 springForces(const Vec6& x, double k, double L0) {
  const Vec3 d = x.tail<3>() - x.head<3>();  // from a to b
  const double L = lengthOf(d);
  Vec6 result = Vec6::Zero();
  if (L > 0) {
    const Vec3 dir = d / L;
    result.head<3>() += k * (L - L0) * dir;
    result.tail<3>() -= k * (L - L0) * dir;
  }
  return result;
}
