// loses: ClothEnough, ClothGood, ClothBest; misconception: grows_without_bound
// Analyses the pattern of the cloth's matrix in the first step alone, where entries that are 0 by chance are missing from it.
#include "challenge.h"

#include <Eigen/SparseCholesky>

VecX squeezedRabbit(const Force& force, const VecX& m, const VecX& x0, const VecX& v0) {
  const int steps = 120;
  const double h = rabbitDuration / steps;
  VecX x = x0, v = v0;
  for (int i = 0; i < steps; ++i) {
    const double t = i * h;
    const VecX k1 = force(t, x, v).cwiseQuotient(m);
    const VecX middle = x + 0.5 * h * v + h * h / 8 * k1;
    const VecX k2 = force(t + 0.5 * h, middle, v).cwiseQuotient(m);
    const VecX last = x + h * v + h * h / 2 * k2;
    const VecX k3 = force(t + h, last, v).cwiseQuotient(m);
    x += h * v + h * h / 6 * (k1 + 2 * k2);
    v += h / 6 * (k1 + 4 * k2 + k3);
  }
  return x;
}

VecX stiffCloth(const Force& force, const Hessian& hessian, const VecX& m, const VecX& x0, const VecX& v0) {
  const int steps = 100;
  const double h = clothDuration / steps;
  const Eigen::SparseMatrix<double> M(m.asDiagonal());
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver;
  VecX x = x0, v = v0;
  for (int i = 0; i < steps; ++i) {
    const double t = (i + 0.5) * h;
    // the middle xm = x + h/2 v + h^2/4 a(xm), one step of Newton from x + h/2 v
    const VecX guess = x + 0.5 * h * v;
    const Eigen::SparseMatrix<double> A = M + 0.25 * h * h * hessian(t, guess);
    if (i == 0) solver.analyzePattern(A);
    solver.factorize(A);
    const VecX a = solver.solve(force(t, guess, v));
    x += h * v + 0.5 * h * h * a;
    v += h * a;
  }
  return x;
}

VecX bouncingBall(const Force& force, const VecX& m, const VecX& x0, const VecX& v0) {
  const double tolerance = 2e-6, longest = 0.05;
  const Eigen::Index n = x0.size();
  VecX y(2 * n);
  y << x0, v0;
  const auto f = [&](double t, const VecX& state) {
    VecX dy(2 * n);
    dy << state.tail(n), force(t, state.head(n), state.tail(n)).cwiseQuotient(m);
    return dy;
  };
  double t = 0, h = 1e-3;
  VecX k1 = f(t, y);
  while (t < ballDuration) {
    const bool isLast = t + h >= ballDuration;
    if (isLast) h = ballDuration - t;
    const VecX k2 = f(t + h / 5, y + h * (k1 / 5));
    const VecX k3 = f(t + h * 3 / 10, y + h * (k1 * 3 / 40 + k2 * 9 / 40));
    const VecX k4 = f(t + h * 4 / 5, y + h * (k1 * 44 / 45 - k2 * 56 / 15 + k3 * 32 / 9));
    const VecX k5 =
        f(t + h * 8 / 9, y + h * (k1 * 19372 / 6561 - k2 * 25360 / 2187 + k3 * 64448 / 6561 - k4 * 212 / 729));
    const VecX k6 = f(t + h, y + h * (k1 * 9017 / 3168 - k2 * 355 / 33 + k3 * 46732 / 5247 + k4 * 49 / 176 -
                                      k5 * 5103 / 18656));
    const VecX next =
        y + h * (k1 * 35 / 384 + k3 * 500 / 1113 + k4 * 125 / 192 - k5 * 2187 / 6784 + k6 * 11 / 84);
    const VecX k7 = f(t + h, next);
    const VecX error = h * (k1 * 71 / 57600 - k3 * 71 / 16695 + k4 * 71 / 1920 - k5 * 17253 / 339200 + k6 * 22 / 525 -
                            k7 / 40);
    const double ratio = error.cwiseAbs().maxCoeff() / tolerance;
    if (ratio <= 1) {
      t = isLast ? ballDuration : t + h;
      y = next;
      k1 = k7;
    }
    h = std::min(longest, h * std::clamp(0.9 * std::pow(ratio + 1e-12, -0.2), 0.2, 3.0));
  }
  return y.head(n);
}
