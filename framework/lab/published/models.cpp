#include "lab/published/models.h"

#include "engine/analysis/linearised_system.h"
#include "engine/control/simulate.h"
#include "engine/integrators/catalogue.h"
#include "engine/solve/dense.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace muelle::published {

using namespace engine;

namespace {

constexpr double apart = 100.0;  // in the unit of length; the largest displacement of a problem is below 20

RunResult runOf(const ModelSystem& system, double duration, double dt, double h) {
  RunOptions options;
  options.duration = duration;
  options.fixedStep = true;
  options.h = h;
  options.outputInterval = dt;
  const RunResult result = simulate(system, *makeMethod("dop853"), system.initialState(), options);
  if (result.failed()) throw std::runtime_error(result.trajectory.stop.message);
  return result;
}

}  // namespace

Model row(const std::vector<double>& masses, const std::vector<RowSpring>& springs) {
  Model model;
  model.dimension = 1;
  for (std::size_t i = 0; i < masses.size(); ++i) {
    model.nodes.push_back({.x = Vec3::UnitX() * apart * static_cast<double>(i + 1), .m = masses[i]});
  }
  const int left = static_cast<int>(std::ssize(masses));
  model.nodes.push_back({.pinned = true});
  model.nodes.push_back({.x = Vec3::UnitX() * apart * static_cast<double>(left + 1), .pinned = true});
  for (const RowSpring& s : springs) {
    ModelSpring spring;
    spring.a = s.a < 0 ? left - 1 - s.a : s.a;
    spring.b = s.b < 0 ? left - 1 - s.b : s.b;
    spring.k = s.k;
    spring.L0 = std::abs(
        (model.nodes[static_cast<std::size_t>(spring.a)].x - model.nodes[static_cast<std::size_t>(spring.b)].x)[0]);
    spring.dProjected = s.c;
    model.springs.push_back(spring);
  }
  return model;
}

Motion1D motionAt(const Model& model, int node, double t, double h) {
  const std::unique_ptr<ModelSystem> system = build(model);
  const RunResult result = runOf(*system, t, t, h);
  const double start = model.nodes[static_cast<std::size_t>(node)].x[0];
  return {system->position(result.last, node)[0] - start, system->velocity(result.last, node)[0]};
}

std::vector<Motion1D> motionOf(const Model& model, int node, double duration, double dt, double h) {
  const std::unique_ptr<ModelSystem> system = build(model);
  const Trajectory trajectory = runOf(*system, duration, dt, h).trajectory;
  const auto lane = static_cast<std::size_t>(system->lane(node, 0));
  const double start = model.nodes[static_cast<std::size_t>(node)].x[0];
  std::vector<Motion1D> motion;
  for (std::size_t i = 0; i < trajectory.t.size(); ++i) {
    motion.push_back({trajectory.x[i][lane] - start, trajectory.v[i][lane]});
  }
  return motion;
}

std::vector<double> frequenciesOf(const Model& model) {
  const std::unique_ptr<ModelSystem> system = build(model);
  const LinearisedSystem linear(*system, system->initialState());
  const int n = linear.size();
  MatX K(n, n);
  VecX unit = VecX::Zero(n);
  for (int i = 0; i < n; ++i) {
    unit[i] = 1.0;
    linear.stiffness({unit.data(), static_cast<std::size_t>(n)}, {K.col(i).data(), static_cast<std::size_t>(n)});
    unit[i] = 0.0;
  }
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const auto mass = system->mass();
      K(i, j) /= std::sqrt(mass[static_cast<std::size_t>(i)] * mass[static_cast<std::size_t>(j)]);
    }
  }
  const VecX squares = symmetricEigenvalues(K);
  std::vector<double> frequencies;
  for (const double square : squares) frequencies.push_back(std::sqrt(square) / (2.0 * std::numbers::pi));
  return frequencies;
}

}  // namespace muelle::published
