/// \file
/// The expected values, arranged in another way than the statement: the energy is the mean force over the stretch times
/// the stretch; the gradient is that of the terms of k (L^2 - 2 L L0 + L0^2) / 2, with grad(L^2) = 2 d and
/// grad(L) = d / L, where d = xa - xb.

#include "energy_gradient.h"

namespace {

struct Separation {
  Vec3 d;    ///< xa - xb [m]
  double L;  ///< its length [m], without underflow in the squares
};

Separation separation(const Vec3& xa, const Vec3& xb) {
  const Vec3 d = xa - xb;
  return {d, std::hypot(d[0], d[1], d[2])};
}

double energyOfLength(double L, double k, double L0) {
  const double meanForce = k * (L - L0) / 2;
  return meanForce * (L - L0);
}

}  // namespace

namespace oracle {

double springEnergy1d(const Vec2& x, double k, double L0) {
  return energyOfLength(std::max(x[0], x[1]) - std::min(x[0], x[1]), k, L0);
}

double springEnergy(const Vec6& x, double k, double L0) {
  return energyOfLength(separation(Vec3(x.head<3>()), Vec3(x.tail<3>())).L, k, L0);
}

Vec3 lengthGradient(const Vec3& xa, const Vec3& xb) {
  const auto [d, L] = separation(xa, xb);
  if (L == 0) return Vec3::Zero();
  return {d[0] / L, d[1] / L, d[2] / L};
}

Vec6 energyGradient(const Vec6& x, double k, double L0) {
  const auto [d, L] = separation(Vec3(x.head<3>()), Vec3(x.tail<3>()));
  Vec6 gradient = Vec6::Zero();
  if (L == 0) return gradient;
  const double factor = k * (1 - L0 / L);
  for (int i = 0; i < 3; ++i) {
    gradient[i] = factor * d[i];
    gradient[3 + i] = -factor * d[i];
  }
  return gradient;
}

Vec6 springForces(const Vec6& x, double k, double L0) { return -energyGradient(x, k, L0); }

}  // namespace oracle
