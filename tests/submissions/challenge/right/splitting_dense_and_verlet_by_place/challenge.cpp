#include "challenge.h"

#include <Eigen/Cholesky>

#include <array>

// Accelerations of a force that needs no velocity are asked with whatever velocity there is.

VecX squeezedRabbit(const Force& force, const VecX& m, const VecX& x0, const VecX& v0) {
  // Yoshida's and Forest's triple jump is too coarse; Blanes and Moan give better numbers for six kicks a step.
  constexpr double b1 = 0.0829844064174052, b2 = 0.396309801498368, b3 = -0.0390563049223486;
  constexpr double a1 = 0.245298957184271, a2 = 0.604872665711080;
  constexpr std::array<double, 7> kick = {b1, b2, b3, 1 - 2 * (b1 + b2 + b3), b3, b2, b1};
  constexpr std::array<double, 7> drift = {a1, a2, 0.5 - a1 - a2, 0.5 - a1 - a2, a2, a1, 0};
  constexpr int steps = 45;
  constexpr double h = rabbitDuration / steps;
  VecX x = x0, v = v0, a = force(0, x, v).array() / m.array();
  for (int i = 0; i < steps; ++i) {
    double t = i * h;
    for (std::size_t j = 0; j < 7; ++j) {
      v.noalias() += h * kick[j] * a;
      if (j == 6) break;
      x.noalias() += h * drift[j] * v;
      t += h * drift[j];
      a = force(t, x, v).array() / m.array();
    }
  }
  return x;
}

VecX stiffCloth(const Force& force, const Hessian& hessian, const VecX& m, const VecX& x0, const VecX& v0) {
  // The matrix has 300 rows: that can be solved without thinking of its zeros.
  const int steps = 75;
  const double h = clothDuration / steps;
  VecX x = x0, v = v0;
  for (int i = 0; i < steps; ++i) {
    const double t = (i + 0.5) * h;
    const VecX q = x + v * (h / 2);
    Eigen::MatrixXd A = Eigen::MatrixXd(hessian(t, q));
    A *= h * h / 4;
    A += m.asDiagonal();
    const VecX half = v * (h / 2) + A.ldlt().solve(VecX(force(t, q, v) * (h * h / 4)));
    x += 2 * half;
    v = half * (4 / h) - v;
  }
  return x;
}

VecX bouncingBall(const Force& force, const VecX& m, const VecX& x0, const VecX& v0) {
  const double tiny = 6e-5, longest = 0.01, g = 9.8;
  VecX x = x0, v = v0, a = force(0, x0, v0).cwiseQuotient(m);
  for (double t = 0, h = 0; ballDuration - t > 1e-12; t += h) {
    h = tiny;
    if (x.z() > 0) {
      const double untilGround = (v.z() + std::sqrt(v.z() * v.z() + 2 * g * x.z())) / g;
      h = std::clamp(untilGround - 2 * tiny, tiny, longest);
    }
    h = std::min(h, ballDuration - t);
    x += h * v + h * h / 2 * a;
    const VecX next = force(t + h, x, v + h * a).cwiseQuotient(m);
    v += h / 2 * (a + next);
    a = next;
  }
  return x;
}
