/// \file
/// What a run says of its error against the truth, on scenes drawn at random, with references of two sources
/// (references.h).

#include "lab/run/energy_balance.h"
#include "lab/run/error_estimate.h"
#include "random_scene.h"
#include "references.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace muelle::lab {

using namespace engine;
namespace {

/// What came of one scene.
struct Trial {
  bool failed = false;  ///< did not reach its end or gains energy, and says so first: there is nothing to estimate
  std::string failure;
  double reported = 0.0;
  bool known = false;  ///< both references reached the end, and something moves
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
  result.failed = run.result.failed() || run.energy.fails();
  if (result.failed) return result;
  const ErrorEstimate estimate = estimateError(scene, run);
  result.failure = estimate.failure;
  result.reported = estimate.error();
  const std::vector<std::size_t> rows = comparedRows(run.result.trajectory);
  std::vector<double> times;
  for (std::size_t i = 1; i < rows.size(); ++i) times.push_back(run.result.trajectory.t[rows[i]]);
  const State start = run.system->initialState();
  State moved = start;
  for (std::size_t i = 0; i < moved.x.size(); ++i) moved.x[i] += (i % 2 == 0 ? 1e-8 : -1e-8);
  const Trajectory exact = finestRun(scene, *run.system, start, times);
  const Trajectory other = secondRun(scene, *run.system, start, times);
  const Trajectory perturbed = finestRun(scene, *run.system, moved, times);
  if (exact.stop.stopped || other.stop.stopped || perturbed.stop.stopped) return result;  // no sure reference
  std::vector<std::size_t> all(exact.t.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  const Sizes motion = motionOf(scene, *run.system, exact);
  if (motion.position == 0.0 || motion.velocity == 0.0) return result;  // doubtful: nothing moves
  result.known = true;
  result.truth = sizeOf(differenceOf(scene, *run.system, run.result.trajectory, rows, exact), motion);
  result.doubt = sizeOf(differenceOf(scene, *run.system, exact, all, other), motion);
  const Sizes apart = differenceOf(scene, *run.system, exact, all, perturbed);
  result.growth = apart.position / 1e-8;
  return result;
}

/// What is in a scene that bears on its error.
std::string kindsOf(const Scene& scene) {
  const Model& model = scene.model;
  std::string kinds;
  const auto add = [&kinds](bool has, const char* kind) { kinds += has ? std::string(", ") + kind : ""; };
  add(!scene.locateEvents, "no events");
  add(!model.obstacles.empty(), "contact");
  add(!model.obstacles.empty() && model.obstacles[0].material.mu > 0.0, "friction");
  add(!model.obstacles.empty() && model.obstacles[0].velocity.norm() > 0.0, "moved obstacle");
  add(!model.motions.empty(), "moved node");
  add(!model.externalForces.empty(), "force");
  add(std::ranges::any_of(model.springs, [](const ModelSpring& spring) { return spring.unilateral; }), "one-sided");
  add(std::ranges::any_of(model.springs, [](const ModelSpring& spring) { return spring.rod; }), "rods");
  add(std::ranges::any_of(model.springs, [](const ModelSpring& spring) { return spring.isSigned; }), "signed");
  add(!model.angles.empty() || !model.dihedrals.empty(), "bending");
  add(!model.areas.empty() || !model.volumes.empty(), "area or volume");
  return kinds;
}

/// Scenes of seeds from `first` on; prints those that are off.
struct Study {
  int smooth = 0, silent = 0, off = 0, failed = 0, chaotic = 0, doubtful = 0;

  void run(std::uint64_t first, int count) {
    for (int i = 0; i < count; ++i) take(first + static_cast<std::uint64_t>(i));
  }
  void take(std::uint64_t seed) {
    const Scene scene = randomScene(seed);
    const Trial t = trial(scene);
    if (t.failed) {
      ++failed;
      return;
    }
    if (t.growth > 1e4) {
      ++chaotic;
      return;
    }
    // Below rounding no factor can be told: what is said has to be small. Else the truth has to be known to 1 %.
    const bool atRounding = t.known && t.truth + t.doubt < 1e-11;
    if (!atRounding && (!t.known || t.truth < 100.0 * t.doubt)) {
      ++doubtful;
      say(seed, scene, fmt::format("no sure reference: {:.3g} off, known to {:.3g}", t.truth, t.doubt));
      return;
    }
    ++smooth;
    const double least = atRounding ? 0.0 : 0.5 * t.truth;
    const double most = atRounding ? 1e-9 : 2.0 * t.truth;
    const bool wrong = t.failure.empty() && !(t.reported >= least && t.reported <= most);
    silent += t.failure.empty() ? 0 : 1;
    off += wrong ? 1 : 0;
    if (!wrong && t.failure.empty()) return;
    say(seed, scene, fmt::format("reported {:.3g}, true {:.3g} {}", t.reported, t.truth, t.failure));
  }
  /// At once: a study is long, and may be ended.
  static void say(std::uint64_t seed, const Scene& scene, const std::string& what) {
    fmt::print(
        "seed {}: {} in {}D, {}, T = {:.3g} s{}: {}\n", seed, scene.method, scene.model.dimension,
        scene.tolerance ? fmt::format("tolerance {:.2g}", *scene.tolerance) : fmt::format("h = {:.3g} s", *scene.step),
        scene.duration, kindsOf(scene), what);
    std::fflush(stdout);
  }
};

TEST(ErrorStudy, TellsTheTruthWithinAFactorOfTwo) {
  const char* count = std::getenv("MUELLE_STUDY");
  const char* first = std::getenv("MUELLE_STUDY_SEED");
  Study study;
  study.run(first != nullptr ? std::strtoull(first, nullptr, 10) : 1, count != nullptr ? std::atoi(count) : 10);
  EXPECT_EQ(study.off, 0);
  EXPECT_LE(study.silent, 1 + study.smooth / 10);
  EXPECT_LE(study.doubtful, 1 + study.smooth * 5 / 100);
  fmt::print("{} told, {} silent, {} off; left out: {} failed, {} chaotic, {} without a sure reference\n",
             study.smooth - study.silent, study.silent, study.off, study.failed, study.chaotic, study.doubtful);
}

TEST(ErrorStudy, TellsTheTruthOfRodsThatMayTouch) {
  Study study;
  int found = 0;
  for (std::uint64_t seed = 1; found < 4; ++seed) {
    const Model model = randomScene(seed).model;
    if (model.obstacles.empty() || std::ranges::none_of(model.springs, &ModelSpring::rod)) continue;
    ++found;
    study.run(seed, 1);
  }
  EXPECT_EQ(study.off, 0);
  EXPECT_GE(study.smooth, 2);
}

// Kinds that were off once. 41: rods whose steps fail and go on in pieces, outputs a rounding apart. 1339: the motion
// of all runs is far larger than the true one, so that parts of it say nothing. 2097: runs with a half and a quarter of
// the step agree by accident.
TEST(ErrorStudy, TellsTheTruthWhereItDidNot) {
  Study study;
  for (const std::uint64_t seed : {41, 1339, 2097}) study.run(seed, 1);
  EXPECT_EQ(study.off, 0);
}

// Backward Euler at a fold of the energy: pieces of a step succeed, grow, and fail again, without headway.
TEST(ErrorStudy, ARunThatFailsInPiecesAgainAndAgainEnds) {
  // Backward Euler, whose Newton iteration fails in many of 450 steps before all of their pieces do.
  const SceneRun run = runScene(randomScene(1746));
  ASSERT_TRUE(run.result.failed());
  EXPECT_LT(run.result.work.rejectedSteps, 10'000);
  EXPECT_NE(run.result.trajectory.stop.message.find("again and again"), std::string::npos);
}

}  // namespace
}  // namespace muelle::lab
