// Rabbit: Verlet with 60, 100 and 160 steps extrapolated over the whole time; cloth: implicit midpoint whose Hessian serves two steps; ball: Runge-Kutta with long steps in the air that end at the ground, short ones in it, and no step across the surface.
#include "challenge.h"

#include <Eigen/SparseCholesky>

static VecX verlet(const Force& force, const VecX& m, VecX x, VecX v, double duration, int steps) {
  const double h = duration / steps;
  VecX a = (force(0, x, v).array() / m.array()).matrix();
  for (int i = 1; i <= steps; i++) {
    v += 0.5 * h * a;
    x += h * v;
    if (i == steps) break;  // the last velocity is not needed
    a = (force(i * h, x, v).array() / m.array()).matrix();
    v += 0.5 * h * a;
  }
  return x;
}

VecX squeezedRabbit(const Force& force, const VecX& m, const VecX& x0, const VecX& v0) {
  const std::vector<int> n = {60, 100, 160};
  std::vector<VecX> row;
  for (std::size_t i = 0; i < n.size(); i++) {
    row.push_back(verlet(force, m, x0, v0, rabbitDuration, n[i]));
    // Aitken and Neville: the error is a series in h^2
    for (std::size_t j = i; j-- > 0;) {
      const double q = double(n[i]) / n[j];
      row[j] = row[j + 1] + (row[j + 1] - row[j]) / (q * q - 1);
    }
  }
  return row[0];
}

VecX stiffCloth(const Force& force, const Hessian& hessian, const VecX& m, const VecX& x0, const VecX& v0) {
  const int steps = 140;
  const double h = clothDuration / steps;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver;
  VecX x = x0, v = v0;
  for (int i = 0; i < steps; i++) {
    const double t = (i + 0.5) * h;
    VecX middle = x + 0.5 * h * v;
    if (i % 2 == 0) {
      Eigen::SparseMatrix<double> A = hessian(t, x + h * v);
      A *= h * h / 4;
      A.diagonal() += m;
      solver.compute(A);
    }
    for (int turn = 0; turn < 3; turn++) {
      const VecX residual = h * h / 4 * force(t, middle, v) - m.cwiseProduct(middle - x - 0.5 * h * v);
      middle += solver.solve(residual);
    }
    const VecX newX = 2 * middle - x;
    v = 2 * (newX - x) / h - v;
    x = newX;
  }
  return x;
}

VecX bouncingBall(const Force& force, const VecX& m, const VecX& x0, const VecX& v0) {
  const Eigen::Index n = x0.size(), z = 2, vz = n + 2;
  const auto f = [&](double t, const VecX& y) -> VecX {
    VecX r(2 * n);
    r.head(n) = y.tail(n);
    r.tail(n) = force(t, y.head(n), y.tail(n)).array() / m.array();
    return r;
  };
  VecX y(2 * n);
  y.head(n) = x0;
  y.tail(n) = v0;
  double t = 0;
  bool ground = y[z] < 0;
  while (t < ballDuration) {
    double h = std::min(ground ? 4e-4 : 0.03, ballDuration - t);
    const VecX k1 = f(t, y);
    const auto go = [&](double s) -> VecX {
      const VecX k2 = f(t + s / 2, y + s / 2 * k1);
      const VecX k3 = f(t + s / 2, y + s / 2 * k2);
      const VecX k4 = f(t + s, y + s * k3);
      return y + s * (k1 + 2 * k2 + 2 * k3 + k4) / 6;
    };
    if (!ground && y[vz] < 0) {
      // when a parabola of now would be at the ground: no stage may dip in before
      const double b = y[vz], g = -k1[vz];
      h = std::min(h, std::max(1e-6, (b + std::sqrt(b * b + 2 * g * y[z])) / g));
    }
    VecX next = go(h);
    if (ground && next[z] > 0) {  // leaves the ground in this step: until there alone
      const double gone = y[z] / (y[z] - next[z]);
      h *= gone;
      next = go(h);
      ground = false;
    } else if (!ground && y[vz] < 0 && next[z] < 1e-6) {
      ground = true;
    }
    const bool end = h >= ballDuration - t;
    t += h;
    y = next;
    if (end) break;
  }
  return y.head(n);
}
