// loses: CoincidentNodes; misconception: edge or made_up_direction
// some direction has to be taken
#include "energy_gradient.h"

namespace {

// |(v0, v1, ..., vn-1)| = hypot(vn-1, |(v0, ..., vn-2)|)
double norm(const double* v, int n) {
  if (n == 0) return 0.0;
  return std::hypot(v[n - 1], norm(v, n - 1));
}

double energyOf(double length, double k, double L0) { return 0.5 * k * (length - L0) * (length - L0); }

double slopeOf(double length, double k, double L0) { return k * (length - L0); }

}  // namespace

double springEnergy1d(const Vec2& x, double k, double L0) {
  const double d = x[0] - x[1];
  return energyOf(norm(&d, 1), k, L0);
}

double springEnergy(const Vec6& x, double k, double L0) {
  const Vec3 d = x.head(3) - x.tail(3);
  return energyOf(norm(d.data(), 3), k, L0);
}

Vec3 lengthGradient(const Vec3& xa, const Vec3& xb) {
  const Vec3 d = xa - xb;
  const double L = norm(d.data(), 3);
  if (L == 0) return Vec3::UnitX();
  return d / L;
}

Vec6 energyGradient(const Vec6& x, double k, double L0) {
  const Vec3 xa = x.head(3);
  const Vec3 xb = x.tail(3);
  const Vec3 d = xa - xb;
  const double slope = slopeOf(norm(d.data(), 3), k, L0);
  Vec6 grad;
  grad.head(3) = slope * lengthGradient(xa, xb);
  grad.tail(3) = slope * lengthGradient(xb, xa);
  return grad;
}

Vec6 springForces(const Vec6& x, double k, double L0) {
  Vec6 F = energyGradient(x, k, L0);
  F *= -1.0;
  return F;
}
