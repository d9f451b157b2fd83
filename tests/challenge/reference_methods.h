#pragma once
/// \file
/// The methods of the challenge's work-precision plots, each with steps of one length but for the last.

#include "challenge.h"
#include "hidden/challenge/dormand_prince.h"
#include "hidden/challenge/low_order.h"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <array>
#include <cmath>

namespace reference {

/// What a method is given. \param hessian empty where the scene has none
struct Problem {
  Force force;
  Hessian hessian;
  VecX m, x0, v0;
  double duration;

  VecX acceleration(double t, const VecX& x, const VecX& v) const { return force(t, x, v).cwiseQuotient(m); }
};

inline VecX explicitEuler(const Problem& p, int steps) {
  return low_order::explicitEuler(p.force, p.m, p.x0, p.v0, p.duration, steps);
}

/// The acceleration at the end of a step is that of the next beginning; it is asked with the velocity that the first
/// acceleration leads to.
inline VecX velocityVerlet(const Problem& p, int steps) {
  const double h = p.duration / steps;
  VecX x = p.x0, v = p.v0, a = p.acceleration(0, x, v);
  for (int i = 0; i < steps; ++i) {
    x += h * v + h * h / 2 * a;
    const VecX next = p.acceleration((i + 1) * h, x, v + h * a);
    v += h / 2 * (a + next);
    a = next;
  }
  return x;
}

inline VecX rungeKutta(const Problem& p, int steps) {
  const double h = p.duration / steps;
  VecX x = p.x0, v = p.v0;
  for (int i = 0; i < steps; ++i) {
    const double t = i * h;
    const VecX v1 = v, a1 = p.acceleration(t, x, v1);
    const VecX v2 = v + h / 2 * a1, a2 = p.acceleration(t + h / 2, x + h / 2 * v1, v2);
    const VecX v3 = v + h / 2 * a2, a3 = p.acceleration(t + h / 2, x + h / 2 * v2, v3);
    const VecX v4 = v + h * a3, a4 = p.acceleration(t + h, x + h * v3, v4);
    x += h / 6 * (v1 + 2 * v2 + 2 * v3 + v4);
    v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
  }
  return x;
}

/// Nystrom's method of order four, for forces without velocities: three evaluations a step.
inline VecX nystrom(const Problem& p, int steps) {
  const double h = p.duration / steps;
  VecX x = p.x0, v = p.v0;
  for (int i = 0; i < steps; ++i) {
    const VecX a1 = p.acceleration(i * h, x, v);
    const VecX a2 = p.acceleration(i * h + h / 2, x + h / 2 * v + h * h / 8 * a1, v);
    const VecX a3 = p.acceleration((i + 1) * h, x + h * v + h * h / 2 * a2, v);
    x += h * v + h * h / 6 * (a1 + 2 * a2);
    v += h / 6 * (a1 + 4 * a2 + a3);
  }
  return x;
}

inline VecX backwardEuler(const Problem& p, int steps) {
  return low_order::backwardEuler(p.force, p.hessian, p.m, p.x0, p.v0, p.duration, steps);
}

/// Implicit midpoint; the middle is found by one step of Newton from x + h/2 v.
inline VecX implicitMidpoint(const Problem& p, int steps) {
  const double h = p.duration / steps;
  VecX x = p.x0, v = p.v0;
  for (int i = 0; i < steps; ++i) {
    const double t = i * h + h / 2;
    const VecX guess = x + h / 2 * v;
    Eigen::SparseMatrix<double> A = h * h / 4 * p.hessian(t, guess);
    A.diagonal() += p.m;
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(A);
    const VecX end = 2 * (guess + solver.solve(h * h / 4 * p.force(t, guess, v))) - x;
    v = 2 / h * (end - x) - v;
    x = end;
  }
  return x;
}

/// Rosenbrock's method of two stages and order two that is L-stable, gamma = 1 - 1/sqrt(2).
inline VecX rosenbrock(const Problem& p, int steps) {
  const double h = p.duration / steps, gamma = 1 - std::sqrt(0.5), q = gamma * h;
  VecX x = p.x0, v = p.v0;
  for (int i = 0; i < steps; ++i) {
    const Eigen::SparseMatrix<double> K = p.hessian(i * h, x);
    Eigen::SparseMatrix<double> A = q * q * K;
    A.diagonal() += p.m;
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(A);
    // (1/q - J) (ux, uv) = (rx, rv), where J leads from (x, v) to (v, -K x / m)
    const auto solve = [&](const VecX& rx, const VecX& rv, VecX& ux, VecX& uv) {
      uv = solver.solve(q * rv - q * q * (K * rx));
      ux = q * (rx + uv);
    };
    VecX x1, v1, x2, v2;
    solve(v, p.force(i * h, x, v), x1, v1);
    const VecX middle = x + x1 / gamma, speed = v + v1 / gamma;
    solve(speed - 2 / q * x1, p.force(i * h, middle, speed) - 2 / q * p.m.cwiseProduct(v1), x2, v2);
    x += (1.5 * x1 + 0.5 * x2) / gamma;
    v += (1.5 * v1 + 0.5 * v2) / gamma;
  }
  return x;
}

/// Dormand's and Prince's method of order five: its last slope is the next first one, and steps have an estimated error
/// below 10^-digits.
inline VecX dormandPrince(const Problem& p, int digits) {
  using namespace dormand_prince;
  const double tolerance = std::pow(10.0, -digits);
  const Eigen::Index n = p.m.size();
  const auto slope = [&](double t, const VecX& y) {
    VecX both(2 * n);
    both << y.tail(n), p.acceleration(t, y.head(n), y.tail(n));
    return both;
  };
  VecX y(2 * n);
  y << p.x0, p.v0;
  std::array<VecX, 7> k;
  k[0] = slope(0, y);
  double t = 0, h = p.duration / 300;
  while (t < p.duration - 1e-12) {
    h = std::min(h, p.duration - t);
    VecX end = y, error = h * off[0] * k[0];
    for (std::size_t stage = 1; stage < 7; ++stage) {
      end = y;
      for (std::size_t i = 0; i < stage; ++i) end += h * a[stage][i] * k[i];
      k[stage] = slope(t + c[stage] * h, end);
      error += h * off[stage] * k[stage];
    }
    const double ratio =
        std::max(error.head(n).cwiseAbs().maxCoeff(), 0.05 * error.tail(n).cwiseAbs().maxCoeff()) / tolerance;
    if (ratio <= 1) {
      t += h;
      y = end;
      k[0] = k[6];
    }
    h *= std::clamp(0.9 * std::pow(std::max(ratio, 1e-8), -0.2), 0.2, 5.0);
  }
  return y.head(n);
}

}  // namespace reference
