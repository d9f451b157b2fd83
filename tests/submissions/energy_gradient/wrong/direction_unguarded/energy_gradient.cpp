// loses: CoincidentNodes; misconception: unguarded or missing_guard
// only the gradient of the energy has a guard
#include "energy_gradient.h"

// Everything written out by components; hypot does not underflow.

double springEnergy1d(const Vec2& x, double k, double L0) {
  double len = std::fabs(x(0) - x(1));
  double s = len - L0;
  return 0.5 * k * s * s;
}

double springEnergy(const Vec6& x, double k, double L0) {
  double dx = x(0) - x(3);
  double dy = x(1) - x(4);
  double dz = x(2) - x(5);
  double s = std::hypot(dx, dy, dz) - L0;
  return 0.5 * k * s * s;
}

Vec3 lengthGradient(const Vec3& xa, const Vec3& xb) {
  double dx = xa(0) - xb(0);
  double dy = xa(1) - xb(1);
  double dz = xa(2) - xb(2);
  double len = std::hypot(dx, dy, dz);
  return Vec3(dx / len, dy / len, dz / len);
}

Vec6 energyGradient(const Vec6& x, double k, double L0) {
  double dx = x(0) - x(3);
  double dy = x(1) - x(4);
  double dz = x(2) - x(5);
  double len = std::hypot(dx, dy, dz);
  Vec6 g;
  g.setZero();
  if (len == 0.0) {
    return g;
  }
  double dE = k * (len - L0);
  g(0) = dE * (dx / len);
  g(1) = dE * (dy / len);
  g(2) = dE * (dz / len);
  g(3) = -g(0);
  g(4) = -g(1);
  g(5) = -g(2);
  return g;
}

Vec6 springForces(const Vec6& x, double k, double L0) {
  Vec6 g = energyGradient(x, k, L0);
  Vec6 f;
  for (int i = 0; i < 6; i++) {
    f(i) = -g(i);
  }
  return f;
}
