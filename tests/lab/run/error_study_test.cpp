/// \file
/// What a run says of its error against the truth, on scenes drawn at random: their references come from two sources,
/// the engine's dop853 at its tightest and Fehlberg's method of Boost.odeint, which follows contacts without events.

#include "engine/integrators/catalogue.h"
#include "lab/run/error_estimate.h"
#include "random_scene.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <boost/numeric/odeint/integrate/integrate_times.hpp>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <cstdlib>

namespace muelle::lab {

using namespace engine;
namespace {

/// dop853 at a tolerance of 1e-13, at the rows that are compared.
Trajectory byDop853(const Scene& scene, const ModelSystem& system, const State& start,
                    const std::vector<double>& times) {
  RunOptions options;
  options.duration = scene.duration;
  options.tolerance.relative = 1e-13;
  options.sampleTimes = times;
  options.probes = probesOf(scene, system);
  const std::unique_ptr<Integrator> method = makeMethod("dop853");
  return simulate(system, *method, start, options).trajectory;
}

Trajectory byOdeint(const Scene& scene, const ModelSystem& system, const State& start,
                    const std::vector<double>& times) {
  namespace odeint = boost::numeric::odeint;
  using Numbers = std::vector<double>;
  const auto n = static_cast<std::ptrdiff_t>(start.x.size());
  const Numbers z(static_cast<std::size_t>(system.internalSize()), 0.0);  // live: as positions and velocities say
  Numbers y = start.x;
  y.insert(y.end(), start.v.begin(), start.v.end());
  const auto slope = [&](const Numbers& at, Numbers& rate, double t) {
    const Numbers x(at.begin(), at.begin() + n), v(at.begin() + n, at.end());
    Numbers f(x.size());
    system.force(t, x, v, z, f);
    for (std::size_t i = 0; i < x.size(); ++i) {
      rate[i] = v[i];
      rate[x.size() + i] = f[i] / system.mass()[i];
    }
  };
  Trajectory trajectory;
  trajectory.tracks.resize(probesOf(scene, system).size());
  const auto record = [&](const Numbers& at, double t) {
    trajectory.t.push_back(t);
    trajectory.x.emplace_back(at.begin(), at.begin() + n);
    trajectory.v.emplace_back(at.begin() + n, at.end());
    for (Track& track : trajectory.tracks) track.values.push_back(0.0);
  };
  std::vector<double> all = {0.0};
  all.insert(all.end(), times.begin(), times.end());
  odeint::integrate_times(odeint::make_controlled(1e-13, 1e-13, odeint::runge_kutta_fehlberg78<Numbers>()), slope, y,
                          all.begin(), all.end(), 1e-4, record);
  return trajectory;
}

/// What came of one scene.
struct Trial {
  std::string failure;
  double reported = 0.0;
  double truth = 0.0;
  double doubt = 0.0;   ///< of the truth: what the two references differ by
  double growth = 0.0;  ///< of a small perturbation of the start
};

double sizeOf(const Sizes& difference, const Sizes& motion) {
  return std::max(difference.position / motion.position, difference.velocity / motion.velocity);
}

Trial trial(const Scene& scene) {
  Trial result;
  const SceneRun run = runScene(scene);
  const ErrorEstimate estimate = estimateError(scene, run);
  result.failure = estimate.failure;
  result.reported = estimate.error();
  const std::vector<std::size_t> rows = comparedRows(run.result.trajectory);
  std::vector<double> times;
  for (std::size_t i = 1; i < rows.size(); ++i) times.push_back(run.result.trajectory.t[rows[i]]);
  const State start = run.system->initialState();
  State moved = start;
  for (std::size_t i = 0; i < moved.x.size(); ++i) moved.x[i] += (i % 2 == 0 ? 1e-8 : -1e-8);
  const Trajectory exact = byDop853(scene, *run.system, start, times);
  const Trajectory other = byOdeint(scene, *run.system, start, times);
  const Trajectory perturbed = byDop853(scene, *run.system, moved, times);
  if (exact.stop.stopped || perturbed.stop.stopped || run.result.failed()) {
    result.growth = std::numeric_limits<double>::infinity();
    return result;
  }
  std::vector<std::size_t> all(exact.t.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  const Sizes motion = motionOf(scene, *run.system, exact);
  result.truth = sizeOf(differenceOf(scene, *run.system, run.result.trajectory, rows, exact), motion);
  result.doubt = sizeOf(differenceOf(scene, *run.system, exact, all, other), motion);
  const Sizes apart = differenceOf(scene, *run.system, exact, all, perturbed);
  result.growth = apart.position / 1e-8;
  return result;
}

/// Scenes of seeds from `first` on; prints those that are off.
struct Study {
  int smooth = 0, silent = 0, off = 0, chaotic = 0, doubtful = 0;

  void run(std::uint64_t first, int count) {
    for (int i = 0; i < count; ++i) take(first + static_cast<std::uint64_t>(i));
  }
  void take(std::uint64_t seed) {
    const Scene scene = randomScene(seed);
    const Trial t = trial(scene);
    if (t.growth > 1e4) {
      ++chaotic;
      return;
    }
    // A truth within a factor 100 of what the references differ by, or of rounding, is none.
    if (t.truth < 100.0 * t.doubt || t.truth < 1e-11) {
      ++doubtful;
      return;
    }
    ++smooth;
    const bool wrong = t.failure.empty() && !(t.reported >= 0.5 * t.truth && t.reported <= 2.0 * t.truth);
    silent += t.failure.empty() ? 0 : 1;
    off += wrong ? 1 : 0;
    if (!wrong && t.failure.empty()) return;
    fmt::print("seed {}: {} in {}D, h = {:.3g} s, T = {:.3g} s, {}: reported {:.3g}, true {:.3g} {}\n", seed,
               scene.method, scene.model.dimension, *scene.step, scene.duration,
               scene.model.obstacles.empty() ? "smooth" : "contact", t.reported, t.truth, t.failure);
  }
};

TEST(ErrorStudy, TellsTheTruthWithinAFactorOfTwo) {
  const char* count = std::getenv("MUELLE_STUDY");
  const char* first = std::getenv("MUELLE_STUDY_SEED");
  Study study;
  study.run(first != nullptr ? std::strtoull(first, nullptr, 10) : 1, count != nullptr ? std::atoi(count) : 10);
  EXPECT_EQ(study.off, 0);
  EXPECT_LE(study.silent, 1 + study.smooth / 10);
  fmt::print("{} told, {} silent, {} off; left out: {} chaotic, {} without a sure reference\n",
             study.smooth - study.silent, study.silent, study.off, study.chaotic, study.doubtful);
}

}  // namespace
}  // namespace muelle::lab
