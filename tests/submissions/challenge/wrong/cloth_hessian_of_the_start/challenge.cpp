// loses: ClothEnough, ClothGood, ClothBest; misconception: too_inexact or grows_without_bound
// The student asks for the Hessian once, at the beginning, and makes one turn of Newton in each step with it.
#include "challenge.h"

#include <Eigen/SparseCholesky>

VecX squeezedRabbit(const Force& force, const VecX& m, const VecX& x0, const VecX& v0) {
  const int steps = 130;
  const double h = rabbitDuration / steps;
  VecX x = x0, v = v0;
  for (int i = 0; i < steps; ++i) {
    const double t = i * h;
    const VecX k1 = force(t, x, v).cwiseQuotient(m);
    const VecX k2 = force(t + h / 2, x + h / 2 * v + h * h / 8 * k1, v).cwiseQuotient(m);
    const VecX k3 = force(t + h, x + h * v + h * h / 2 * k2, v).cwiseQuotient(m);
    x += h * v + h * h / 6 * (k1 + 2 * k2);
    v += h / 6 * (k1 + 4 * k2 + k3);
  }
  return x;
}

VecX stiffCloth(const Force& force, const Hessian& hessian, const VecX& m, const VecX& x0, const VecX& v0) {
  const int steps = 100;
  const double h = clothDuration / steps;
  Eigen::SparseMatrix<double> M(m.size(), m.size());
  M.setIdentity();
  M.diagonal() = m;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver;
  const Eigen::SparseMatrix<double> K = hessian(0, x0);
  const Eigen::SparseMatrix<double> A = M + h * h / 4 * K;
  solver.compute(A);
  VecX x = x0, v = v0;
  for (int i = 0; i < steps; ++i) {
    const double t = (i + 0.5) * h;
    // the unknown is the middle y = x + h/2 v + h^2/4 M^-1 F(y); the guess leaves out the force
    const VecX y = x + h / 2 * v;
    const VecX middle = y + solver.solve(h * h / 4 * force(t, y, v));
    const VecX vMiddle = (middle - x) * (2 / h);
    x = 2 * middle - x;
    v = 2 * vMiddle - v;
  }
  return x;
}

VecX bouncingBall(const Force& force, const VecX& m, const VecX& x0, const VecX& v0) {
  static const double c[7] = {0, 1.0 / 5, 3.0 / 10, 4.0 / 5, 8.0 / 9, 1, 1};
  static const double a[7][6] = {
      {},
      {1.0 / 5},
      {3.0 / 40, 9.0 / 40},
      {44.0 / 45, -56.0 / 15, 32.0 / 9},
      {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
      {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
      {35.0 / 384, 0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84}};
  static const double b4[7] = {5179.0 / 57600,    0,           7571.0 / 16695, 393.0 / 640,
                               -92097.0 / 339200, 187.0 / 2100, 1.0 / 40};
  const Eigen::Index n = x0.size();
  const double tolerance = 1e-6;
  auto slope = [&](double t, const VecX& y) {
    VecX dy(2 * n);
    dy << y.tail(n), force(t, y.head(n), y.tail(n)).cwiseQuotient(m);
    return dy;
  };
  VecX y(2 * n);
  y << x0, v0;
  double t = 0, h = 1e-3;
  VecX k[7];
  k[0] = slope(t, y);
  while (t < ballDuration) {
    const bool last = t + h >= ballDuration;
    if (last) h = ballDuration - t;
    VecX next = y;
    for (int s = 1; s < 7; ++s) {
      next = y;
      for (int j = 0; j < s; ++j) next += h * a[s][j] * k[j];
      k[s] = slope(t + c[s] * h, next);
    }
    VecX difference = VecX::Zero(2 * n);
    for (int s = 0; s < 7; ++s) difference += h * ((s < 6 ? a[6][s] : 0.0) - b4[s]) * k[s];
    const double error = difference.cwiseAbs().maxCoeff() / tolerance;
    if (error <= 1) {
      t = last ? ballDuration : t + h;
      y = next;
      k[0] = k[6];
    }
    h *= std::clamp(0.9 * std::pow(std::max(error, 1e-10), -0.2), 0.2, 5.0);
  }
  return y.head(n);
}
