#pragma once
/// \file
/// The methods of first order: in as many steps as a submission has asked, where they end is where it ends that uses
/// them.

#include "challenge.h"

#include <Eigen/SparseCholesky>

#include <algorithm>

namespace low_order {

inline VecX explicitEuler(const Force& force, const VecX& m, VecX x, VecX v, double T, long steps) {
  const double h = T / static_cast<double>(steps);
  for (long step = 0; step < steps; ++step) {
    const VecX a = force(static_cast<double>(step) * h, x, v).cwiseQuotient(m);
    x += h * v;
    v += h * a;
  }
  return x;
}

inline VecX symplecticEuler(const Force& force, const VecX& m, VecX x, VecX v, double T, long steps) {
  const double h = T / static_cast<double>(steps);
  for (long step = 0; step < steps; ++step) {
    v += h * force(static_cast<double>(step) * h, x, v).cwiseQuotient(m);
    x += h * v;
  }
  return x;
}

/// The linearised equation (M + h^2 K) dv = h (F - h K v): one Hessian and one force a step.
inline VecX backwardEuler(const Force& force, const Hessian& hessian, const VecX& m, VecX x, VecX v, double T,
                          long steps) {
  const double h = T / static_cast<double>(steps);
  for (long step = 0; step < steps; ++step) {
    const double t = static_cast<double>(step) * h;
    const Eigen::SparseMatrix<double> K = hessian(t, x);
    Eigen::SparseMatrix<double> A = h * h * K;
    A.diagonal() += m;
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(A);
    v += solver.solve(h * (force(t, x, v) - h * (K * v)));
    x += h * v;
  }
  return x;
}

/// How near the motion comes to a point [m], from the start to a fifth beyond the end.
inline double nearestDistance(const Force& force, const VecX& m, VecX x, VecX v, double T, long steps,
                              const VecX& point) {
  const double h = T / static_cast<double>(steps);
  double nearest = (x - point).cwiseAbs().maxCoeff();
  for (long step = 0; step < steps + steps / 5; ++step) {
    v += h * force(static_cast<double>(step) * h, x, v).cwiseQuotient(m);
    x += h * v;
    nearest = std::min(nearest, (x - point).cwiseAbs().maxCoeff());
  }
  return nearest;
}

}  // namespace low_order
