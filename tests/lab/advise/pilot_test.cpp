#include "lab/advise/pilot.h"

#include "lab/advise/reference_motion.h"
#include "spring_scene.h"

#include <gtest/gtest.h>
#include <cmath>
#include <numbers>

namespace muelle::lab {

using namespace engine;
namespace {

TEST(Looks, StepsAreHardlyShorterAndSomeEndAtTheTimes) {
  const Scene scene = springScene(5.0);
  const Looks looks(scene);
  for (double h = 2.5; h > 1e-4; h *= 0.83) {
    const auto steps = static_cast<double>(looks.stepsOf(h));
    EXPECT_LE(scene.duration / steps, h * (1.0 + 1e-9));
    // The next multiple of m is at most m - 1 away, of 10 m steps or more; below 24 some gaps are of a fifth.
    EXPECT_LE(steps, 1.27 * std::ceil(scene.duration / h)) << h;
    const std::vector<std::size_t> met = looks.ofSteps(looks.stepsOf(h));
    for (const std::size_t look : met) {
      const double step = looks.time(look) * steps / scene.duration;
      EXPECT_NEAR(step, std::round(step), 1e-6);
    }
    EXPECT_GE(met.size(), steps > 480.0 ? 48U : 1U);
  }
}

/// The error of velocity Verlet is that of its frequency, w' = 2/h asin(h w / 2): at most 0.2 |cos w't - cos wt| of a
/// motion of 0.4 m, and likewise for the velocity. Phase: w t (h w)^2 / 24 = 50 * 0.0004 / 24 = 8.3e-4 at h w = 0.02,
/// which is the error of the velocity (its largest is w 0.2) where the phase is right.
TEST(Pilots, TheErrorOfVerletIsThatOfItsFrequency) {
  const Scene scene = springScene(5.0);
  const std::unique_ptr<ModelSystem> system = build(scene.model);
  const Pilots pilots(scene, *system);
  const ReferenceMotion reference = findReference(pilots, 1e-6, 10.0);
  ASSERT_TRUE(reference.stands()) << reference.failure;
  EXPECT_NEAR(reference.run.motion.position, 0.4, 1e-3);  // seen at ends of steps
  EXPECT_NEAR(reference.run.motion.velocity, 2.0, 2e-2);
  EXPECT_LE(reference.doubt, 1e-6 / 50.0);
  const PilotRun run = pilots.run({"velocity_verlet", true, 0.002}, {});
  ASSERT_TRUE(run.done()) << run.failure;
  const double h = run.setting.value;
  EXPECT_NEAR(reference.errorOf(pilots, run.rows), 50.0 * 100.0 * h * h / 24.0, 0.03 * 8.3e-4);
}

TEST(Pilots, AnAdaptiveRunIsComparedAtItsOwnEndsOfSteps) {
  const Scene scene = springScene(5.0);
  const std::unique_ptr<ModelSystem> system = build(scene.model);
  const Pilots pilots(scene, *system);
  const ReferenceMotion reference = findReference(pilots, 1e-8, 10.0);
  const PilotRun run = pilots.run({"nystrom12", false, 1e-6}, {});
  ASSERT_TRUE(run.done());
  EXPECT_LT(run.steps, 60);  // not one for each of 240 looks
  double worst = 0.0;
  for (std::size_t i = 0; i < run.rows.size(); ++i) {
    const double t = run.rows.t[i];
    worst = std::max(worst, std::abs(run.rows.x[i][3] - (1.0 + 0.2 * std::cos(10.0 * t))) / 0.4);
    worst = std::max(worst, std::abs(run.rows.v[i][3] + 2.0 * std::sin(10.0 * t)) / 2.0);
  }
  EXPECT_NEAR(reference.errorOf(pilots, run.rows), worst, 0.05 * worst + 1e-9);
}

TEST(Pilots, ARunThatTakesTooLongIsGivenUp) {
  Scene scene = springScene(5.0);
  scene.duration = 5e4;
  const std::unique_ptr<ModelSystem> system = build(scene.model);
  const PilotRun run = Pilots(scene, *system).run({"velocity_verlet", true, 1e-4}, {.seconds = 0.02});
  EXPECT_TRUE(run.outOfTime);
  EXPECT_FALSE(run.done());
  EXPECT_GT(run.reached, 0.0);
  const PilotRun costly = Pilots(scene, *system).run({"velocity_verlet", true, 1e-4}, {.ofProcessor = 0.02});
  EXPECT_TRUE(costly.outOfTime);
  EXPECT_GT(costly.seconds, 0.02);
}

/// A ball that falls from 1 m touches the ground after sqrt(2 / g) s; a second obstacle, 1 m above, keeps its gap but
/// for the way of a step.
TEST(Pilots, GapsAndTouchesAreWatched) {
  Scene scene;
  scene.model.dimension = 1;
  scene.model.gravity = {-9.81, 0.0, 0.0};
  scene.model.nodes.resize(1);
  scene.model.nodes[0].x = {1.0, 0.0, 0.0};
  Obstacle ground, roof;
  ground.normal = Vec3::UnitX();
  roof.normal = -Vec3::UnitX();
  roof.centre = {2.0, 0.0, 0.0};
  scene.model.obstacles = {ground, roof};
  scene.method = "velocity_verlet";
  scene.step = 1e-3;
  scene.duration = 0.5;
  const std::unique_ptr<ModelSystem> system = build(scene.model);
  const PilotRun run = Pilots(scene, *system).run({"velocity_verlet", true, 1e-3}, {.watchesGaps = true});
  EXPECT_NEAR(run.firstTouch[0], std::sqrt(2.0 / 9.81), 2e-3);
  EXPECT_TRUE(std::isinf(run.firstTouch[1]));
  EXPECT_NEAR(run.leastGap[1], 1.0, 0.01);
  EXPECT_TRUE(run.touches());
}

}  // namespace
}  // namespace muelle::lab
