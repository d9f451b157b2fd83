#include "references.h"

#include "engine/control/step_planner.h"
#include "engine/integrators/catalogue.h"

#include <algorithm>
#include <array>
#include <boost/numeric/odeint/integrate/integrate_times.hpp>
#include <boost/numeric/odeint/stepper/bulirsch_stoer.hpp>
#include <cmath>
#include <Eigen/Dense>

namespace muelle::lab {

using namespace engine;

namespace {

using Numbers = std::vector<double>;

Trajectory byTolerance(const char* id, double tolerance, const Scene& scene, const ModelSystem& system,
                       const State& start, const std::vector<double>& times) {
  RunOptions options;
  options.duration = scene.duration;
  options.tolerance.relative = tolerance;
  options.mostForceEvaluations = 500'000;  // a reference that takes more is none
  options.sampleTimes = times;
  options.probes = probesOf(scene, system);
  const std::unique_ptr<Integrator> method = makeMethod(id);
  return simulate(system, *method, start, options).trajectory;
}

Trajectory byRattle(double h, const Scene& scene, const ModelSystem& system, const State& start,
                    const std::vector<double>& times) {
  RunOptions options;
  options.duration = scene.duration;
  options.h = h;
  options.fixedStep = true;
  options.sampleTimes = times;
  options.checkStability = options.checkNumericalDamping = false;
  options.probes = probesOf(scene, system);
  const std::unique_ptr<Integrator> method = makeMethod("rattle");
  return simulate(system, *method, start, options).trajectory;
}

/// What is left of a and b, whose errors are as `ratio` to 1, without the error.
void extrapolate(double ratio, const Trajectory& a, Trajectory& b) {
  const auto each = [ratio](const Numbers& coarse, Numbers& fine) {
    for (std::size_t i = 0; i < fine.size(); ++i) fine[i] += (fine[i] - coarse[i]) / (ratio - 1.0);
  };
  for (std::size_t row = 0; row < b.t.size(); ++row) {
    each(a.x[row], b.x[row]);
    each(a.v[row], b.v[row]);
  }
}

/// Adds the forces of the rods that keep d^2 L / dt^2 = 0: G M^-1 (f + G^T s) = -(dG/dt) v.
void addRodForces(const ModelSystem& system, const Numbers& x, const Numbers& v, Numbers& f) {
  const auto rods = system.rods();
  if (rods.empty()) return;
  const auto count = static_cast<Eigen::Index>(rods.size()), n = static_cast<Eigen::Index>(f.size());
  Eigen::MatrixXd G = Eigen::MatrixXd::Zero(count, n);
  Eigen::VectorXd right(count);
  const int dimension = system.dimension();
  for (Eigen::Index j = 0; j < count; ++j) {
    const Rod& rod = rods[static_cast<std::size_t>(j)];
    double squares = 0.0;
    for (std::size_t c = 0; c < static_cast<std::size_t>(dimension); ++c) {
      const auto a = static_cast<std::size_t>(rod.a[c]), b = static_cast<std::size_t>(rod.b[c]);
      squares += (v[a] - v[b]) * (v[a] - v[b]);
      G(j, rod.a[c]) = x[a] - x[b];
      G(j, rod.b[c]) = x[b] - x[a];
    }
    right[j] = -squares;
  }
  const Eigen::Map<const Eigen::VectorXd> inverse(system.inverseMass().data(), n);
  Eigen::Map<Eigen::VectorXd> force(f.data(), n);
  right -= G * inverse.cwiseProduct(force);
  force += G.transpose() * (G * inverse.asDiagonal() * G.transpose()).ldlt().solve(right);
}

Trajectory byOdeint(const Scene& scene, const ModelSystem& system, const State& start,
                    const std::vector<double>& times) {
  namespace odeint = boost::numeric::odeint;
  const auto n = static_cast<std::ptrdiff_t>(start.x.size());
  const Numbers z(static_cast<std::size_t>(system.internalSize()), 0.0);  // live: as positions and velocities say
  Numbers y = start.x;
  y.insert(y.end(), start.v.begin(), start.v.end());
  const auto slope = [&](const Numbers& at, Numbers& rate, double t) {
    Numbers x(at.begin(), at.begin() + n), v(at.begin() + n, at.end());
    system.place(t, z, x, v);
    Numbers f(x.size());
    system.force(t, x, v, z, f);
    addRodForces(system, x, v, f);
    for (std::size_t i = 0; i < x.size(); ++i) {
      rate[i] = v[i];
      rate[x.size() + i] = f[i] * system.inverseMass()[i];
    }
  };
  Trajectory trajectory;
  trajectory.tracks.resize(probesOf(scene, system).size());
  const auto record = [&](const Numbers& at, double t) {
    Numbers x(at.begin(), at.begin() + n), v(at.begin() + n, at.end());
    system.place(t, z, x, v);
    trajectory.t.push_back(t);
    trajectory.x.push_back(std::move(x));
    trajectory.v.push_back(std::move(v));
    for (Track& track : trajectory.tracks) track.values.push_back(0.0);
  };
  std::vector<double> all = {0.0};
  all.insert(all.end(), times.begin(), times.end());
  // Steps end where a force jumps, too.
  std::vector<double> ends = declaredTimes(system, 0.0, scene.duration);
  ends.insert(ends.end(), all.begin(), all.end());
  std::ranges::sort(ends);
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  const auto recordTimes = [&](const Numbers& at, double t) {
    if (std::ranges::binary_search(all, t)) record(at, t);
  };
  odeint::integrate_times(odeint::bulirsch_stoer<Numbers>(1e-13, 1e-13), slope, y, ends.begin(), ends.end(), 1e-4,
                          recordTimes);
  return trajectory;
}

bool rubs(const Model& model) {
  return std::ranges::any_of(model.obstacles, [](const Obstacle& obstacle) { return obstacle.material.mu > 0.0; });
}

}  // namespace

Trajectory finestRun(const Scene& scene, const ModelSystem& system, const State& start,
                     const std::vector<double>& times) {
  if (system.rods().empty()) return byTolerance("dop853", 1e-13, scene, system, start, times);
  const double steps = scene.duration / *scene.step;
  double finest = 256.0;
  while (finest < 2048.0 && 2.0 * finest * steps < 1e5) finest *= 2.0;
  std::array<Trajectory, 4> runs;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    runs[i] = byRattle(*scene.step * std::pow(2.0, 3.0 - static_cast<double>(i)) / finest, scene, system, start, times);
    if (runs[i].stop.stopped) return runs[i];
  }
  // The kink of a contact leaves no expansion of the error in the step: the finest run is then as good as it is.
  if (!scene.model.obstacles.empty()) return runs.back();
  for (std::size_t level = 1; level < runs.size(); ++level) {
    const double ratio = std::pow(4.0, static_cast<double>(level));
    for (std::size_t i = runs.size() - 1; i >= level; --i) extrapolate(ratio, runs[i - 1], runs[i]);
  }
  return runs.back();
}

Trajectory secondRun(const Scene& scene, const ModelSystem& system, const State& start,
                     const std::vector<double>& times) {
  if (rubs(scene.model)) return byTolerance("dormand_prince_5", 1e-12, scene, system, start, times);
  return byOdeint(scene, system, start, times);
}

}  // namespace muelle::lab
