#pragma once
/// \file
/// The methods of first order, in as many steps as a submission has asked: where they end is where it ends that uses
/// them.

#include "scenes.h"

#include <Eigen/SparseCholesky>

namespace trials {

using muelle::VecX;

template <class Scene>
VecX explicitEulerEnd(const Scene& scene, long steps) {
  const double h = Scene::duration / static_cast<double>(steps);
  VecX x = scene.positions(), v = scene.velocities();
  for (long step = 0; step < steps; ++step) {
    const VecX a = scene.force(static_cast<double>(step) * h, x, v).cwiseQuotient(scene.masses());
    x += h * v;
    v += h * a;
  }
  return x;
}

template <class Scene>
VecX symplecticEulerEnd(const Scene& scene, long steps) {
  const double h = Scene::duration / static_cast<double>(steps);
  VecX x = scene.positions(), v = scene.velocities();
  for (long step = 0; step < steps; ++step) {
    v += h * scene.force(static_cast<double>(step) * h, x, v).cwiseQuotient(scene.masses());
    x += h * v;
  }
  return x;
}

/// Linearised, with one Hessian a step.
inline VecX backwardEulerEnd(const scenes::Cloth& scene, long steps) {
  const double h = scenes::Cloth::duration / static_cast<double>(steps);
  VecX x = scene.positions(), v = scene.velocities();
  for (long step = 0; step < steps; ++step) {
    const scenes::Matrix K = scene.hessian(0, x);
    scenes::Matrix A = h * h * K;
    A.diagonal() += scene.masses();
    const Eigen::SimplicialLDLT<scenes::Matrix> solver(A);
    v += solver.solve(h * (scene.force(0, x, v) - h * (K * v)));
    x += h * v;
  }
  return x;
}

/// How near the motion comes to a point, and when, from the start to a fifth beyond the end.
template <class Scene>
struct Nearest {
  double time = 0, distance = 0;

  Nearest(const Scene& scene, const VecX& point, long steps) {
    const double h = Scene::duration / static_cast<double>(steps);
    VecX x = scene.positions(), v = scene.velocities();
    distance = (x - point).cwiseAbs().maxCoeff();
    for (long step = 0; step < steps + steps / 5; ++step) {
      v += h * scene.force(static_cast<double>(step) * h, x, v).cwiseQuotient(scene.masses());
      x += h * v;
      const double now = (x - point).cwiseAbs().maxCoeff();
      if (now >= distance) continue;
      distance = now;
      time = static_cast<double>(step + 1) * h;
    }
  }
};

}  // namespace trials
