#include "time_integration.h"

namespace {

/// A system that knows its force and its masses
class System {
 public:
  System(const Force& f, const VecX& m) : f_(f), m_(m) {}
  State rate(const State& s) const {
    State r;
    r.t = 1.0;  // time goes on by itself
    r.x = s.v;
    r.v = f_(s.t, s.x, s.v);
    for (Eigen::Index i = 0; i < r.v.size(); ++i) r.v(i) /= m_(i);
    return r;
  }

 private:
  const Force& f_;
  const VecX& m_;
};

State operator+(const State& a, const State& b) { return {a.t + b.t, a.x + b.x, a.v + b.v}; }
State operator*(double h, const State& s) { return {h * s.t, h * s.x, h * s.v}; }

}  // namespace

State explicitEulerStep(const Force& force, const VecX& m, const State& now, double h) {
  const System system(force, m);
  return now + h * system.rate(now);
}

State midpointStep(const Force& force, const VecX& m, const State& now, double h) {
  const System system(force, m);
  return now + h * system.rate(now + h / 2 * system.rate(now));
}

State verletStep(const PositionForce& force, const VecX& m, const State& now, double h) {
  const auto a = [&](double t, const VecX& x) -> VecX { return force(t, x).cwiseQuotient(m); };
  const VecX a0 = a(now.t, now.x);
  State next = now;
  next.t += h;
  next.x += h * now.v + 0.5 * h * h * a0;
  next.v += 0.5 * h * (a0 + a(next.t, next.x));
  return next;
}

State rungeKuttaStep(const Force& force, const VecX& m, const State& now, double h) {
  const System system(force, m);
  const State k1 = system.rate(now);
  const State k2 = system.rate(now + h / 2 * k1);
  const State k3 = system.rate(now + h / 2 * k2);
  const State k4 = system.rate(now + h * k3);
  return now + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
}
