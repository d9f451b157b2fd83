/// \file
/// What the adviser says of its choice against the truth, on scenes drawn at random, with references of two sources.

#include "lab/advise/advice.h"
#include "lab/run/deviation.h"
#include "lab/run/run_scene.h"
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

PathRows rowsOf(const ModelSystem& system, const Trajectory& trajectory) {
  PathRows rows;
  for (std::size_t i = 0; i < trajectory.t.size(); ++i) {
    rows.add(system, {trajectory.t[i], trajectory.x[i], trajectory.v[i], {}});
  }
  return rows;
}

/// The truth about a run of what was advised, at the outputs that `muelle run` would make.
struct Truth {
  bool known = false;
  double error = 0.0, doubt = 0.0, growth = 0.0;
};

Truth truthOf(const Scene& scene, const SceneRun& run) {
  Truth truth;
  const std::unique_ptr<ModelSystem> system = build(scene.model);
  const std::vector<double> times(run.result.trajectory.t.begin() + 1, run.result.trajectory.t.end());
  const State start = system->initialState();
  State moved = start;
  for (std::size_t i = 0; i < moved.x.size(); ++i) moved.x[i] += (i % 2 == 0 ? 1e-8 : -1e-8);
  const Trajectory exact = finestRun(scene, *system, start, times);
  const Trajectory other = secondRun(scene, *system, start, times);
  const Trajectory perturbed = finestRun(scene, *system, moved, times);
  if (exact.stop.stopped || other.stop.stopped || perturbed.stop.stopped) return truth;
  // Few outputs can miss how far and fast nodes go between them.
  std::vector<double> often;
  for (int i = 1; i <= 400; ++i) often.push_back(std::min(scene.duration, scene.duration * i / 400.0));
  const Sizes size = nodeMotion(*system, finestRun(scene, *system, start, often));
  const MotionSize motion{size.position, size.velocity};
  if (motion.position == 0.0 || motion.velocity == 0.0) return truth;
  truth.known = true;
  const PathRows reference = rowsOf(*system, exact);
  truth.error = errorIn(distanceOf(rowsOf(*run.system, run.result.trajectory), reference), motion);
  truth.doubt = errorIn(distanceOf(rowsOf(*system, other), reference), motion);
  truth.growth = distanceOf(rowsOf(*system, perturbed), reference).position / 1e-8;
  return truth;
}

struct AdviceStudy {
  int told = 0, refused = 0, above = 0, loose = 0, missed = 0, leftOut = 0, unclear = 0, chaotic = 0;

  void take(std::uint64_t seed) {
    const Scene scene = randomScene(seed);
    const double tolerance = std::pow(10.0, -2.0 - static_cast<double>(seed % 5));
    const Advice advice = advise(scene, {.tolerance = tolerance, .budget = 10.0});
    const Candidate* chosen = advice.chosen();
    const SceneRun run = runScene(chosen != nullptr ? advice.scene : scene);
    const Truth truth = truthOf(scene, run);
    const std::string what = chosen != nullptr ? fmt::format("{}, {}, said {:.2g}", chosen->setting.name(),
                                                             chosen->setting.valueText(), chosen->error)
                                               : "refused: " + advice.refusal;
    const auto say = [&](const char* verdict) {
      fmt::print("seed {} at {:.0e}: {}, true {:.3g} (known to {:.1g}, growth {:.1g}): {}\n", seed, tolerance, what,
                 truth.error, truth.doubt, truth.growth, verdict);
      std::fflush(stdout);
    };
    if (truth.growth > 1e4) {
      ++chaotic;
      return;
    }
    if (chosen == nullptr) {
      // Whether a scene without a sure reference is chaotic nobody can tell: there the adviser is right to refuse.
      ++(truth.known ? refused : unclear);
      say("refused");
      return;
    }
    const bool atRounding = truth.known && truth.error + truth.doubt < 1e-11;
    if (run.result.failed() || (!atRounding && (!truth.known || truth.error < 20.0 * truth.doubt))) {
      ++unclear;
      say("no sure reference");
      return;
    }
    ++told;
    leftOut += advice.leftOut().empty() ? 0 : 1;
    if (truth.error > chosen->error) {
      ++above;
      say("above what was said");
    }
    if (truth.error > tolerance) ++missed;
    if (!atRounding && chosen->error > 10.0 * truth.error) {
      ++loose;
      say("said far too much");
    }
  }
};

TEST(AdviceStudy, TheErrorIsAtMostWhatWasSaid) {
  const char* count = std::getenv("MUELLE_STUDY");
  const char* first = std::getenv("MUELLE_STUDY_SEED");
  AdviceStudy study;
  const std::uint64_t begin = first != nullptr ? std::strtoull(first, nullptr, 10) : 1;
  const int scenes = count != nullptr ? std::atoi(count) : 12;
  for (int i = 0; i < scenes; ++i) study.take(begin + static_cast<std::uint64_t>(i));
  fmt::print(
      "{} told, of these {} above what was said, {} above the tolerance, {} said more than ten times too much, {} "
      "with parts left out; {} refused; left out: {} chaotic, {} without a sure reference\n",
      study.told, study.above, study.missed, study.loose, study.leftOut, study.refused, study.chaotic, study.unclear);
  // Of few scenes one may be off; of many 1 %, 20 %, 20 %.
  EXPECT_LE(study.above, study.told / 100);
  EXPECT_LE(study.loose, 1 + study.told / 5);
  EXPECT_LE(study.refused, 1 + (study.told + study.refused) / 5);
}

}  // namespace
}  // namespace muelle::lab
