#include "engine/model/damping.h"
#include "lab/run/energy_balance.h"
#include "lab/run/run_scene.h"

#include <gtest/gtest.h>
#include <cmath>
#include <set>

namespace muelle::lab {

using namespace engine;
namespace {

std::vector<std::string> sceneNames() {
  std::vector<std::string> names;
  for (const auto& file : listScenes(MUELLE_SCENES)) names.push_back(file.stem().string());
  return names;
}

Scene shipped(const std::string& name) { return readScene(findScene(name, MUELLE_SCENES)); }

class ShippedScene : public ::testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(, ShippedScene, ::testing::ValuesIn(sceneNames()),
                         [](const auto& test) { return test.param; });

TEST_P(ShippedScene, BuildsAndRunsAFewStepsFinitely) {
  Scene scene = shipped(GetParam());
  EXPECT_LE(scene.title.size(), 70u);
  // Ten steps of a fixed step; an adaptive method chooses its own for as long.
  scene.duration = std::min(scene.duration, 10.0 * scene.step.value_or(0.01));
  scene.outputInterval = 0.0;
  const SceneRun run = runScene(scene);
  EXPECT_FALSE(run.result.failed()) << run.result.trajectory.stop.message;
  EXPECT_GE(run.result.work.steps, 1);
  for (const double x : run.result.last.x) ASSERT_TRUE(std::isfinite(x));
  for (const Track& track : run.result.trajectory.tracks) {
    for (const double value : track.values) ASSERT_TRUE(std::isfinite(value)) << track.name;
  }
}

TEST(ShippedScenes, AreThoseOfTheLecture) {
  const std::vector<std::string> there = sceneNames();
  const std::set<std::string> names(there.begin(), there.end());
  for (const char* name : {"oscillator", "elastic_pendulum", "dumbbell", "triangle", "hanging_chain", "whip",
                           "cloth_on_sphere", "corner_hung_cloth", "damping_dominated_cloth", "bouncing_ball",
                           "column_at_rest", "jelly_box", "rabbit_squeezed", "rabbit_at_rest"}) {
    EXPECT_TRUE(names.contains(name)) << name;
  }
}

TEST(HangingChain, EndsWhereTheForcesSumToZero) {
  const Scene scene = shipped("hanging_chain");
  const SceneRun run = runScene(scene);
  std::vector<double> f(run.result.last.x.size());
  run.system->force(run.result.last.t, run.result.last.x, run.result.last.v, run.result.last.z, f);
  // Against a node's weight, 0.1 * 9.81 N.
  for (int i = 0; i < run.system->size(); ++i) EXPECT_LT(std::abs(f[laneOf(*run.system, i)]), 1e-3 * 0.981);
}

TEST(ColumnAtRest, EverySpringCarriesWhatLiesAboveIt) {
  const SceneRun run = runScene(shipped("column_at_rest"));
  const double weight = 9.81;  // of a block of 1 kg
  const double k = 1e4;
  double height = -10.0 * weight / k;  // the ground carries all ten
  for (int block = 0; block < 10; ++block) {
    EXPECT_NEAR(run.system->position(run.result.last, block)[0], height, 1e-8) << block;
    height += 0.1 - (9 - block) * weight / k;
  }
}

TEST(BouncingBall, ComesBackToItsHeight) {
  const SceneRun run = runScene(shipped("bouncing_ball"));
  const EnergyBalance& balance = run.energy;
  EXPECT_EQ(balance.fate, EnergyFate::Kept);
  // At the outputs in flight; inside the contact the method's energy swings by (h omega)^2 / 8 = 3e-3 of its size.
  EXPECT_LT(balance.highest - balance.lowest, 0.01 * balance.scale);
  const std::vector<double>& E = run.result.trajectory.track("total energy");
  EXPECT_NEAR(E.back(), 9.81, 1e-4 * 9.81);
}

TEST(Whip, TipIsManyTimesFasterThanTheHandle) {
  const SceneRun run = runScene(shipped("whip"));
  const Trajectory& t = run.result.trajectory;
  double tip = 0.0;
  for (const double v : t.track("speed of the tip along x")) tip = std::max(tip, std::abs(v));
  // The handle's greatest speed is that of its stroke, 15/8 of the mean: sqrt(0.5^2 + 1) m in 0.25 s.
  EXPECT_GT(tip, 8.0 * 15.0 / 8.0 * std::hypot(0.5, 1.0) / 0.25);
}

TEST(DampingDominatedCloth, HasADampingRatioOfAtLeastFive) {
  const Scene scene = shipped("damping_dominated_cloth");
  for (const ModelSpring& spring : scene.model.springs) {
    const double m = 0.5 * scene.model.nodes[static_cast<std::size_t>(spring.a)].m;
    EXPECT_GE(projectedDamping(scene.model, spring) / (2.0 * std::sqrt(spring.k * m)), 5.0);
  }
}

}  // namespace
}  // namespace muelle::lab
