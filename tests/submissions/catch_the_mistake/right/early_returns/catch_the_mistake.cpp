#include "catch_the_mistake.h"

bool isSpringForceRight(const SpringForce& springForceOnA) try {
  auto off = [](double got, double want) { return !(std::abs(got - want) <= 1e-7); };
  if (off(springForceOnA(0, 2, 8, 1.5), 4)) return false;
  if (off(springForceOnA(2, 0, 8, 1.5), -4)) return false;
  if (off(springForceOnA(0, 1, 8, 1.5), -4)) return false;
  if (off(springForceOnA(1, 0, 8, 1.5), 4)) return false;
  if (off(springForceOnA(1, 3, 8, 0), 16)) return false;
  if (!(std::abs(springForceOnA(0, 900, 1e5, 0.5) - 89.95e6) < 1)) return false;
  if (off(springForceOnA(9, 9, 8, 1.5), 0)) return false;
  double length = 1e-3;
  while (length > 0.9e-100) {
    if (off(springForceOnA(length, 0, 8, 1.5), 8 * (1.5 - length))) return false;
    if (off(springForceOnA(0, length, 8, 1.5), -8 * (1.5 - length))) return false;
    length /= 10;
  }
  return true;
} catch (...) {
  return false;
}

bool isGradientRight(const SpringEnergy& springEnergy, const EnergyGradient& energyGradient) try {
  const Vec3 way(0.28, 0.576, -0.768);
  auto check = [&](double length, double L0) {
    Vec6 x = Vec6::Zero();
    x.tail(3) = length * way;
    Vec6 g = Vec6::Zero();
    if (length > 0) g << 8 * (L0 - length) * way, 8 * (length - L0) * way;
    if (!(std::abs(springEnergy(x, 8, L0) - 4 * (length - L0) * (length - L0)) < 1e-6)) return false;
    return (energyGradient(x, 8, L0) - g).lpNorm<Eigen::Infinity>() < 1e-7;
  };
  for (double L0 : {0.0, 1.5})
    for (double length : {3.0, 0.6, 0.0})
      if (!check(length, L0)) return false;
  for (int i = 2; i <= 100; ++i)
    if (!check(std::pow(10.0, -i), 1.5)) return false;
  return true;
} catch (...) {
  return false;
}

bool isDampingRight(const ProjectedDamping& projectedDamping) try {
  const Vec3 way(0.28, 0.576, -0.768), here(2, -1, 4), v(1, 2, 4), w(-1, 0.5, 1);
  const double along = way[0] * 2 + way[1] * 1.5 + way[2] * 3;
  auto wrong = [](const Vec3& got, const Vec3& want) { return !((got - want).norm() < 1e-7); };
  if (wrong(projectedDamping(here + 2 * way, here, v, w, 5), -5 * along * way)) return false;
  if (wrong(projectedDamping(here + 2 * way, here, w, v, 5), 5 * along * way)) return false;
  if (wrong(projectedDamping(here, here + 2 * way, v, w, 5), -5 * along * way)) return false;
  if (wrong(projectedDamping(here + 200 * way, here, v, w, 0.5), -0.5 * along * way)) return false;
  if (wrong(projectedDamping(here, here, v, w, 5), Vec3(0, 0, 0))) return false;
  for (int i = 1; i <= 100; ++i)
    if (wrong(projectedDamping(std::pow(10.0, -i) * way, Vec3(0, 0, 0), v, w, 5), -5 * along * way)) return false;
  return true;
} catch (...) {
  return false;
}
