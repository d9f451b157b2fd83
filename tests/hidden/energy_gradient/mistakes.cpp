/// \file
/// What the usual mistakes would return: each is a whole function, so that all calls of a criterion must agree with it.

#include "grader/testing/mistakes.h"

#include <limits>
#include "energy_gradient.h"

namespace {

double length(const Vec6& x) { return (x.head<3>() - x.tail<3>()).norm(); }
Vec3 difference(const Vec6& x) { return x.head<3>() - x.tail<3>(); }
Vec3 unit(const Vec6& x) { return oracle::lengthGradient(Vec3(x.head<3>()), Vec3(x.tail<3>())); }
Vec6 stacked(const Vec3& a, const Vec3& b) {
  Vec6 both;
  both << a, b;
  return both;
}
Vec6 opposite(const Vec3& a) { return stacked(a, -a); }

/// Below every length of the other criteria and above every length of the criterion on very short springs.
constexpr double threshold = 1e-12;

/// What 0 / 0 leaves where nobody looks at L first.
constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

}  // namespace

MUELLE_MISTAKE(springEnergy1d, signed_length, [](const Vec2& x, double k, double L0) {
  const double L = x[0] - x[1];
  return 0.5 * k * (L - L0) * (L - L0);
});
MUELLE_MISTAKE(springEnergy1d, signed_length_reversed, [](const Vec2& x, double k, double L0) {
  const double L = x[1] - x[0];
  return 0.5 * k * (L - L0) * (L - L0);
});
MUELLE_COMMON_MISTAKE(springEnergy1d, missing_half);
MUELLE_MISTAKE(springEnergy1d, missing_rest_length,
               [](const Vec2& x, double k, double) { return oracle::springEnergy1d(x, k, 0); });

MUELLE_MISTAKE(springEnergy1d, not_squared,
               [](const Vec2& x, double k, double L0) { return 0.5 * k * (std::abs(x[0] - x[1]) - L0); });
MUELLE_MISTAKE(springEnergy1d, difference_of_squares,
               [](const Vec2& x, double k, double L0) { return 0.5 * k * ((x[0] - x[1]) * (x[0] - x[1]) - L0 * L0); });
MUELLE_MISTAKE(springEnergy1d, energy_lost_when_coincident, [](const Vec2& x, double k, double L0) {
  return x[0] == x[1] ? 0.0 : oracle::springEnergy1d(x, k, L0);
});

MUELLE_COMMON_MISTAKE(springEnergy, missing_half);
MUELLE_MISTAKE(springEnergy, missing_rest_length,
               [](const Vec6& x, double k, double) { return oracle::springEnergy(x, k, 0); });
MUELLE_MISTAKE(springEnergy, not_squared,
               [](const Vec6& x, double k, double L0) { return 0.5 * k * (length(x) - L0); });
MUELLE_MISTAKE(springEnergy, difference_of_squares, [](const Vec6& x, double k, double L0) {
  const double L = length(x);
  return 0.5 * k * (L * L - L0 * L0);
});
MUELLE_MISTAKE(springEnergy, squared_length, [](const Vec6& x, double k, double L0) {
  const double L2 = difference(x).squaredNorm();
  return 0.5 * k * (L2 - L0) * (L2 - L0);
});
MUELLE_MISTAKE(springEnergy, energy_lost_when_coincident,
               [](const Vec6& x, double k, double L0) { return length(x) > 0 ? oracle::springEnergy(x, k, L0) : 0.0; });

MUELLE_MISTAKE(lengthGradient, wrong_node_or_sign,
               [](const Vec3& xa, const Vec3& xb) { return oracle::lengthGradient(xb, xa); });
MUELLE_MISTAKE(lengthGradient, not_normalised, [](const Vec3& xa, const Vec3& xb) { return Vec3(xa - xb); });
MUELLE_MISTAKE(lengthGradient, gradient_of_squared_length,
               [](const Vec3& xa, const Vec3& xb) { return Vec3(2 * (xa - xb)); });
MUELLE_MISTAKE(lengthGradient, threshold, [](const Vec3& xa, const Vec3& xb) {
  return (xa - xb).norm() < threshold ? Vec3(Vec3::Zero()) : oracle::lengthGradient(xa, xb);
});

MUELLE_MISTAKE(energyGradient, wrong_node_or_sign,
               [](const Vec6& x, double k, double L0) { return Vec6(-oracle::energyGradient(x, k, L0)); });
MUELLE_MISTAKE(energyGradient, one_block_only, [](const Vec6& x, double k, double L0) {
  return stacked(Vec3(oracle::energyGradient(x, k, L0).head<3>()), Vec3::Zero());
});
MUELLE_MISTAKE(energyGradient, same_block_twice, [](const Vec6& x, double k, double L0) {
  const Vec3 a = oracle::energyGradient(x, k, L0).head<3>();
  return stacked(a, a);
});
MUELLE_MISTAKE(energyGradient, not_normalised,
               [](const Vec6& x, double k, double L0) { return opposite(k * (length(x) - L0) * difference(x)); });
MUELLE_MISTAKE(energyGradient, missing_rest_length,
               [](const Vec6& x, double k, double) { return opposite(k * difference(x)); });
MUELLE_COMMON_MISTAKE(energyGradient, half_kept);
MUELLE_MISTAKE(energyGradient, gradient_of_squared_length,
               [](const Vec6& x, double k, double L0) { return opposite(2 * k * (length(x) - L0) * difference(x)); });
MUELLE_MISTAKE(energyGradient, not_differentiated,
               [](const Vec6& x, double k, double L0) { return opposite(oracle::springEnergy(x, k, L0) * unit(x)); });
MUELLE_MISTAKE(energyGradient, threshold, [](const Vec6& x, double k, double L0) {
  return length(x) < threshold ? Vec6(Vec6::Zero()) : oracle::energyGradient(x, k, L0);
});

MUELLE_MISTAKE(springForces, wrong_node_or_sign,
               [](const Vec6& x, double k, double L0) { return oracle::energyGradient(x, k, L0); });
MUELLE_MISTAKE(springForces, same_block_twice, [](const Vec6& x, double k, double L0) {
  const Vec3 a = oracle::springForces(x, k, L0).head<3>();
  return stacked(a, a);
});
MUELLE_MISTAKE(springForces, one_block_only, [](const Vec6& x, double k, double L0) {
  return stacked(Vec3(oracle::springForces(x, k, L0).head<3>()), Vec3::Zero());
});
MUELLE_MISTAKE(springForces, not_normalised,
               [](const Vec6& x, double k, double L0) { return opposite(-k * (length(x) - L0) * difference(x)); });
MUELLE_MISTAKE(springForces, missing_rest_length,
               [](const Vec6& x, double k, double) { return opposite(-k * difference(x)); });
MUELLE_COMMON_MISTAKE(springForces, half_kept);
MUELLE_MISTAKE(springForces, gradient_of_squared_length,
               [](const Vec6& x, double k, double L0) { return opposite(-2 * k * (length(x) - L0) * difference(x)); });
MUELLE_MISTAKE(springForces, threshold, [](const Vec6& x, double k, double L0) {
  return length(x) < threshold ? Vec6(Vec6::Zero()) : oracle::springForces(x, k, L0);
});
MUELLE_MISTAKE(lengthGradient, unguarded, [](const Vec3& xa, const Vec3& xb) {
  return xa == xb ? Vec3(Vec3::Constant(undefined)) : oracle::lengthGradient(xa, xb);
});
MUELLE_MISTAKE(energyGradient, unguarded, [](const Vec6& x, double k, double L0) {
  return length(x) == 0 ? Vec6(Vec6::Constant(undefined)) : oracle::energyGradient(x, k, L0);
});
MUELLE_MISTAKE(springForces, unguarded, [](const Vec6& x, double k, double L0) {
  return length(x) == 0 ? Vec6(Vec6::Constant(undefined)) : oracle::springForces(x, k, L0);
});
MUELLE_MISTAKE(springForces, not_differentiated,
               [](const Vec6& x, double k, double L0) { return opposite(-oracle::springEnergy(x, k, L0) * unit(x)); });
