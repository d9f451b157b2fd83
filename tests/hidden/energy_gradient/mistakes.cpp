/// \file
/// What the usual mistakes would return: each is a whole function, so that all calls of a criterion must agree with it.

#include "grader/remote/mistakes.h"

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

MUELLE_MISTAKE(springEnergy1d, energy_1d_signed_length, [](const Vec2& x, double k, double L0) {
  const double L = x[0] - x[1];
  return 0.5 * k * (L - L0) * (L - L0);
});
MUELLE_MISTAKE(springEnergy1d, energy_1d_signed_length_reversed, [](const Vec2& x, double k, double L0) {
  const double L = x[1] - x[0];
  return 0.5 * k * (L - L0) * (L - L0);
});
MUELLE_MISTAKE(springEnergy1d, energy_1d_missing_half,
               [](const Vec2& x, double k, double L0) { return 2 * oracle::springEnergy1d(x, k, L0); });
MUELLE_MISTAKE(springEnergy1d, energy_1d_missing_rest_length,
               [](const Vec2& x, double k, double) { return oracle::springEnergy1d(x, k, 0); });

MUELLE_MISTAKE(springEnergy, energy_missing_half,
               [](const Vec6& x, double k, double L0) { return 2 * oracle::springEnergy(x, k, L0); });
MUELLE_MISTAKE(springEnergy, energy_missing_rest_length,
               [](const Vec6& x, double k, double) { return oracle::springEnergy(x, k, 0); });
MUELLE_MISTAKE(springEnergy, energy_not_squared,
               [](const Vec6& x, double k, double L0) { return 0.5 * k * (length(x) - L0); });
MUELLE_MISTAKE(springEnergy, energy_difference_of_squares, [](const Vec6& x, double k, double L0) {
  const double L = length(x);
  return 0.5 * k * (L * L - L0 * L0);
});
MUELLE_MISTAKE(springEnergy, energy_squared_length, [](const Vec6& x, double k, double L0) {
  const double L2 = difference(x).squaredNorm();
  return 0.5 * k * (L2 - L0) * (L2 - L0);
});
MUELLE_MISTAKE(springEnergy, energy_zero_when_coincident,
               [](const Vec6& x, double k, double L0) { return length(x) > 0 ? oracle::springEnergy(x, k, L0) : 0.0; });

MUELLE_MISTAKE(lengthGradient, length_gradient_wrong_node,
               [](const Vec3& xa, const Vec3& xb) { return oracle::lengthGradient(xb, xa); });
MUELLE_MISTAKE(lengthGradient, length_gradient_not_normalised,
               [](const Vec3& xa, const Vec3& xb) { return Vec3(xa - xb); });
MUELLE_MISTAKE(lengthGradient, length_gradient_of_squared_length,
               [](const Vec3& xa, const Vec3& xb) { return Vec3(2 * (xa - xb)); });
MUELLE_MISTAKE(lengthGradient, length_gradient_threshold, [](const Vec3& xa, const Vec3& xb) {
  return (xa - xb).norm() < threshold ? Vec3(Vec3::Zero()) : oracle::lengthGradient(xa, xb);
});

MUELLE_MISTAKE(energyGradient, gradient_blocks_swapped,
               [](const Vec6& x, double k, double L0) { return Vec6(-oracle::energyGradient(x, k, L0)); });
MUELLE_MISTAKE(energyGradient, gradient_one_block, [](const Vec6& x, double k, double L0) {
  return stacked(Vec3(oracle::energyGradient(x, k, L0).head<3>()), Vec3::Zero());
});
MUELLE_MISTAKE(energyGradient, gradient_same_block_twice, [](const Vec6& x, double k, double L0) {
  const Vec3 a = oracle::energyGradient(x, k, L0).head<3>();
  return stacked(a, a);
});
MUELLE_MISTAKE(energyGradient, gradient_not_normalised,
               [](const Vec6& x, double k, double L0) { return opposite(k * (length(x) - L0) * difference(x)); });
MUELLE_MISTAKE(energyGradient, gradient_missing_rest_length,
               [](const Vec6& x, double k, double) { return opposite(k * difference(x)); });
MUELLE_MISTAKE(energyGradient, gradient_half_kept,
               [](const Vec6& x, double k, double L0) { return Vec6(0.5 * oracle::energyGradient(x, k, L0)); });
MUELLE_MISTAKE(energyGradient, gradient_of_squared_length,
               [](const Vec6& x, double k, double L0) { return opposite(2 * k * (length(x) - L0) * difference(x)); });
MUELLE_MISTAKE(energyGradient, gradient_not_differentiated,
               [](const Vec6& x, double k, double L0) { return opposite(oracle::springEnergy(x, k, L0) * unit(x)); });
MUELLE_MISTAKE(energyGradient, gradient_threshold, [](const Vec6& x, double k, double L0) {
  return length(x) < threshold ? Vec6(Vec6::Zero()) : oracle::energyGradient(x, k, L0);
});

MUELLE_MISTAKE(springForces, force_is_plus_gradient,
               [](const Vec6& x, double k, double L0) { return oracle::energyGradient(x, k, L0); });
MUELLE_MISTAKE(springForces, force_same_on_both_nodes, [](const Vec6& x, double k, double L0) {
  const Vec3 a = oracle::springForces(x, k, L0).head<3>();
  return stacked(a, a);
});
MUELLE_MISTAKE(springForces, force_only_on_a, [](const Vec6& x, double k, double L0) {
  return stacked(Vec3(oracle::springForces(x, k, L0).head<3>()), Vec3::Zero());
});
MUELLE_MISTAKE(springForces, force_not_normalised,
               [](const Vec6& x, double k, double L0) { return opposite(-k * (length(x) - L0) * difference(x)); });
MUELLE_MISTAKE(springForces, force_missing_rest_length,
               [](const Vec6& x, double k, double) { return opposite(-k * difference(x)); });
MUELLE_MISTAKE(springForces, force_half_kept,
               [](const Vec6& x, double k, double L0) { return Vec6(0.5 * oracle::springForces(x, k, L0)); });
MUELLE_MISTAKE(springForces, force_of_squared_length,
               [](const Vec6& x, double k, double L0) { return opposite(-2 * k * (length(x) - L0) * difference(x)); });
MUELLE_MISTAKE(springForces, force_threshold, [](const Vec6& x, double k, double L0) {
  return length(x) < threshold ? Vec6(Vec6::Zero()) : oracle::springForces(x, k, L0);
});
MUELLE_MISTAKE(lengthGradient, length_gradient_unguarded, [](const Vec3& xa, const Vec3& xb) {
  return xa == xb ? Vec3(Vec3::Constant(undefined)) : oracle::lengthGradient(xa, xb);
});
MUELLE_MISTAKE(energyGradient, gradient_unguarded, [](const Vec6& x, double k, double L0) {
  return length(x) == 0 ? Vec6(Vec6::Constant(undefined)) : oracle::energyGradient(x, k, L0);
});
MUELLE_MISTAKE(springForces, force_unguarded, [](const Vec6& x, double k, double L0) {
  return length(x) == 0 ? Vec6(Vec6::Constant(undefined)) : oracle::springForces(x, k, L0);
});
