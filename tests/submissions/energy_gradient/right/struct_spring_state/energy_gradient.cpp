#include "energy_gradient.h"

// One small struct that knows all about the spring at x; the functions only read from it.
struct SpringState {
  Vec3 diff;
  double length;
  double stretch;

  SpringState(const Vec3& a, const Vec3& b, double restLength)
      : diff(a - b), length(diff.stableNorm()), stretch(length - restLength) {}

  Vec3 unit() const {
    if (!(length > 0)) return Vec3::Zero();
    return diff / length;
  }
  double energy(double k) const { return 0.5 * k * stretch * stretch; }
  double tension(double k) const { return k * stretch; }
};

double springEnergy1d(const Vec2& x, double k, double L0) {
  SpringState s(Vec3(x[0], 0, 0), Vec3(x[1], 0, 0), L0);
  return s.energy(k);
}

double springEnergy(const Vec6& x, double k, double L0) {
  SpringState s(x.head<3>(), x.tail<3>(), L0);
  return s.energy(k);
}

Vec3 lengthGradient(const Vec3& xa, const Vec3& xb) {
  SpringState s(xa, xb, 0.0);
  return s.unit();
}

Vec6 energyGradient(const Vec6& x, double k, double L0) {
  SpringState s(x.head<3>(), x.tail<3>(), L0);
  Vec6 grad;
  grad.head<3>() = s.tension(k) * s.unit();
  grad.tail<3>() = -s.tension(k) * s.unit();
  return grad;
}

Vec6 springForces(const Vec6& x, double k, double L0) {
  SpringState s(x.head<3>(), x.tail<3>(), L0);
  Vec6 force;
  force.head<3>() = -s.tension(k) * s.unit();
  force.tail<3>() = s.tension(k) * s.unit();
  return force;
}
