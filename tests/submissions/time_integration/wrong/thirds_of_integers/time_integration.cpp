// loses: RungeKutta, Order, Stability, Energies; misconception: integer_division
// The weights of Runge-Kutta are quotients of integers, all zero: the state stays where it is.
#include "time_integration.h"

using Derivative = std::function<VecX(double, const VecX&)>;

static VecX stack(const VecX& x, const VecX& v) {
  VecX y(x.size() + v.size());
  y << x, v;
  return y;
}

static State unstack(double t, const VecX& y) {
  const auto n = y.size() / 2;
  return {t, y.head(n), y.tail(n)};
}

static State general(const Force& force, const VecX& m, const State& now, double h,
                     const std::vector<std::vector<double>>& A, const std::vector<double>& b) {
  const auto n = now.x.size();
  const Derivative f = [&](double t, const VecX& y) {
    const VecX x = y.head(n);
    const VecX v = y.tail(n);
    const VecX F = force(t, x, v);
    return stack(v, F.cwiseQuotient(m));
  };
  const VecX y0 = stack(now.x, now.v);
  std::vector<VecX> slopes;
  for (const auto& row : A) {
    VecX y = y0;
    double c = 0;
    for (std::size_t j = 0; j < row.size(); ++j) {
      y += h * row[j] * slopes[j];
      c += row[j];
    }
    slopes.push_back(f(now.t + c * h, y));
  }
  VecX y = y0;
  for (std::size_t i = 0; i < b.size(); ++i) y += h * b[i] * slopes[i];
  return unstack(now.t + h, y);
}

State explicitEulerStep(const Force& force, const VecX& m, const State& now, double h) {
  return general(force, m, now, h, {{}}, {1});
}

State midpointStep(const Force& force, const VecX& m, const State& now, double h) {
  return general(force, m, now, h, {{}, {0.5}}, {0, 1});
}

State verletStep(const PositionForce& force, const VecX& m, const State& now, double h) {
  const VecX vHalf = now.v + h / 2 * force(now.t, now.x).cwiseQuotient(m);
  const VecX x = now.x + h * vHalf;
  const VecX v = vHalf + h / 2 * force(now.t + h, x).cwiseQuotient(m);
  return {now.t + h, x, v};
}

State rungeKuttaStep(const Force& force, const VecX& m, const State& now, double h) {
  return general(force, m, now, h, {{}, {0.5}, {0, 0.5}, {0, 0, 1}}, {1 / 6, 1 / 3, 1 / 3, 1 / 6});
}
