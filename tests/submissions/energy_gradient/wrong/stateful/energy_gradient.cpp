// loses: all; misconception: stateful
#include "energy_gradient.h"

#include <utility>

// Right, one call late.
namespace {
Vec3 lengthGradientOf(const Vec3& xa, const Vec3& xb) {
  const double L = (xa - xb).norm();
  return L > 0 ? Vec3((xa - xb) / L) : Vec3(Vec3::Zero());
}

Vec6 gradientOf(const Vec6& x, double k, double L0) {
  const Vec3 d = x.head<3>() - x.tail<3>();
  const Vec3 a = k * (d.norm() - L0) * lengthGradientOf(x.head<3>(), x.tail<3>());
  return (Vec6() << a, -a).finished();
}
}  // namespace

double springEnergy1d(const Vec2& x, double k, double L0) {
  static double previous = 0.0;
  const double L = std::abs(x[0] - x[1]);
  return std::exchange(previous, 0.5 * k * (L - L0) * (L - L0));
}

double springEnergy(const Vec6& x, double k, double L0) {
  static double previous = 0.0;
  const double L = (x.head<3>() - x.tail<3>()).norm();
  return std::exchange(previous, 0.5 * k * (L - L0) * (L - L0));
}

Vec3 lengthGradient(const Vec3& xa, const Vec3& xb) {
  static Vec3 previous = Vec3::Zero();
  return std::exchange(previous, lengthGradientOf(xa, xb));
}

Vec6 energyGradient(const Vec6& x, double k, double L0) {
  static Vec6 previous = Vec6::Zero();
  return std::exchange(previous, gradientOf(x, k, L0));
}

Vec6 springForces(const Vec6& x, double k, double L0) {
  static Vec6 previous = Vec6::Zero();
  return std::exchange(previous, Vec6(-gradientOf(x, k, L0)));
}
