#include "engine/integrator.h"

#include "engine/integrators/cubic_interpolant.h"

namespace muelle::engine {

namespace {

/// Quintic on [0, 1] from values, slopes and curvatures at both ends (in units of the step).
double quintic(double theta, double x0, double v0, double a0, double x1, double v1, double a1) {
  const double d = x1 - x0 - v0 - 0.5 * a0;
  const double e = v1 - v0 - a0;
  const double f = a1 - a0;
  const double c3 = 10.0 * d - 4.0 * e + 0.5 * f;
  const double c4 = -15.0 * d + 7.0 * e - f;
  const double c5 = 6.0 * d - 3.0 * e + 0.5 * f;
  return x0 + theta * (v0 + theta * (0.5 * a0 + theta * (c3 + theta * (c4 + theta * c5))));
}

}  // namespace

StepResult Integrator::stepIncrement(const DynamicalSystem& system, const State& from, double h, State& increment) {
  StepResult result = step(system, from, h, increment);
  for (std::size_t i = 0; i < from.x.size(); ++i) {
    increment.x[i] -= from.x[i];
    increment.v[i] -= from.v[i];
  }
  return result;
}

void Integrator::updateEnds(const DynamicalSystem& system, const State& from, const State& to) {
  const auto same = [](const State& a, const State& b) { return a.t == b.t && a.x == b.x && a.v == b.v; };
  // All of the step is under the internal variables of its begin: those of `to` may already be the next one's.
  const bool known = same(ends_.from, from) && ends_.from.z == from.z && same(ends_.to, to);
  if (ends_.system == &system && known) return;
  ends_.system = &system;
  ends_.from = from;
  ends_.to = to;
  ends_.accelerationFrom.resize(from.x.size());
  ends_.accelerationTo.resize(from.x.size());
  system.acceleration(from.t, from.x, from.v, from.z, ends_.accelerationFrom);
  State end = to;
  system.place(end.t, from.z, end.x, end.v);  // moved nodes too may be where the next step begins
  system.acceleration(end.t, end.x, end.v, from.z, ends_.accelerationTo);
  work_.forceEvaluations += 2;
}

void Integrator::interpolate(const DynamicalSystem& system, const State& from, const State& to, double theta,
                             State& out) {
  updateEnds(system, from, to);
  const double h = to.t - from.t;
  const auto n = from.x.size();
  out.t = from.t + theta * h;
  out.x.resize(n);
  out.v.resize(n);
  out.z = from.z;
  for (std::size_t i = 0; i < n; ++i) {
    const double a0 = ends_.accelerationFrom[i], a1 = ends_.accelerationTo[i];
    out.x[i] = quintic(theta, from.x[i], h * from.v[i], h * h * a0, to.x[i], h * to.v[i], h * h * a1);
    out.v[i] = cubic(theta, from.v[i], h * a0, to.v[i], h * a1);
  }
}

}  // namespace muelle::engine
