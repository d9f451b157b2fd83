/// \file
/// The expected values, arranged in another way than the statement: the energy is the mean force over the stretch times
/// the stretch; lengths by hypot, whose squares do not underflow.

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

// Blocks of k (L - L0) grad L: what is built on another function asks for that one where it stands for the student's.
Vec6 energyGradient(const Vec6& x, double k, double L0) {
  const Vec3 xa = x.head<3>(), xb = x.tail<3>();
  const double slope = k * (separation(xa, xb).L - L0);
  Vec6 gradient;
  gradient << slope * given::lengthGradient(xa, xb), slope * given::lengthGradient(xb, xa);
  return gradient;
}

Vec6 springForces(const Vec6& x, double k, double L0) { return -given::energyGradient(x, k, L0); }

}  // namespace oracle
