#include "lab/advise/advice.h"

#include "lab/advise/advice_figure.h"
#include "lab/run/run_scene.h"
#include "spring_scene.h"

#include <gmock/gmock.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace muelle::lab {

using namespace engine;
namespace {

using ::testing::HasSubstr;

Scene shipped(const std::string& name) { return readScene(std::filesystem::path(MUELLE_SCENES) / (name + ".toml")); }

const Candidate* candidateIn(const std::vector<Candidate>& all, const std::string& method) {
  const auto place = std::ranges::find(all, method, [](const Candidate& c) { return c.setting.name(); });
  return place == all.end() ? nullptr : &*place;
}

/// The advised run against the analytic solution at each end of a step, in parts of 0.4 m and 2 m/s.
TEST(Advice, TheRunIsAsExactAsWasSaid) {
  for (const double tolerance : {1e-1, 1e-3, 1e-5, 1e-8}) {
    const Advice advice = advise(springScene(6.3), {.tolerance = tolerance, .budget = 60.0});
    ASSERT_NE(advice.chosen(), nullptr) << advice.refusal;
    EXPECT_LE(advice.chosen()->error, tolerance);
    const SceneRun run = runScene(advice.scene);
    double error = 0.0;
    const Trajectory& path = run.result.trajectory;
    for (std::size_t i = 0; i < path.t.size(); ++i) {
      const State state{path.t[i], path.x[i], path.v[i], {}};
      error =
          std::max(error, std::abs(run.system->position(state, 1)[0] - 1.0 - 0.2 * std::cos(10.0 * path.t[i])) / 0.4);
      error = std::max(error, std::abs(run.system->velocity(state, 1)[0] + 2.0 * std::sin(10.0 * path.t[i])) / 2.0);
    }
    EXPECT_LE(error, advice.chosen()->error) << tolerance;
    EXPECT_GE(error, 0.05 * advice.chosen()->error) << tolerance;
  }
}

/// At 1e-8 velocity Verlet would need 20 times as many steps as at the 2.5e-5 that it is off with h w = 0.003: whatever
/// the machine, a method of order 8 or 12 is far cheaper.
TEST(Advice, HighOrderIsTakenForSmallErrors) {
  const Advice advice = advise(springScene(6.3), {.tolerance = 1e-8, .budget = 60.0});
  ASSERT_NE(advice.chosen(), nullptr);
  EXPECT_GE(advice.chosen()->estimate.order, 8);
  const Candidate* verlet = candidateIn(advice.methods.candidates, "velocity_verlet");
  ASSERT_NE(verlet, nullptr);
  EXPECT_EQ(verlet->fate, Candidate::Fate::NotRun);
  EXPECT_GT(verlet->seconds, 20.0 * advice.chosen()->seconds);
}

/// All of the oscillator's energy is in its one mode, which is the fastest: 10 rad/s.
TEST(Advice, ThePilotNumberIsTheShareOfFastModes) {
  const Advice one = advise(springScene(6.3), {.tolerance = 1e-3, .budget = 60.0});
  EXPECT_NEAR(one.share.fastest, 10.0, 0.01);
  EXPECT_NEAR(one.share.aboveQuarter, 1.0, 1e-9);
  // A second oscillator, at rest and ten times as fast, leaves it all below a quarter.
  Scene scene = springScene(6.3);
  scene.model.nodes.resize(4);
  scene.model.nodes[2].x = {3.0, 0.0, 0.0};
  scene.model.nodes[2].pinned = true;
  scene.model.nodes[3].x = {4.0, 0.0, 0.0};
  scene.model.springs.push_back({2, 3, 1e4, 1.0});
  const Advice two = advise(scene, {.tolerance = 1e-3, .budget = 60.0});
  EXPECT_NEAR(two.share.fastest, 100.0, 0.1);
  EXPECT_NEAR(two.share.aboveQuarter, 0.0, 1e-9);
}

TEST(Advice, UnfitMethodsAreNamedWithTheReason) {
  Scene scene = springScene(6.3);
  scene.model.springs[0].dProjected = 0.5;
  const Advice advice = advise(scene, {.tolerance = 1e-3, .budget = 60.0});
  const Candidate* nystrom = candidateIn(advice.whole.candidates, "nystrom8");
  ASSERT_NE(nystrom, nullptr);
  EXPECT_EQ(nystrom->fate, Candidate::Fate::Unfit);
  EXPECT_THAT(nystrom->why, HasSubstr("does not depend on the velocity"));
  EXPECT_THAT(adviceText(scene, advice),
              HasSubstr("needs a force that does not depend on the velocity, drag aside: rkn64"));
}

TEST(Advice, NothingIsSaidOfAChaoticScene) {
  // A slack, stiff cloth without bending: runs at 1e-9 of the motion still differ by a tenth of it.
  const Scene scene = shipped("corner_hung_cloth");
  const Advice advice = advise(scene, {.tolerance = 1e-4, .budget = 100.0});
  EXPECT_EQ(advice.chosen(), nullptr);
  EXPECT_THAT(advice.refusal, HasSubstr("differ by"));
  EXPECT_THAT(adviceText(scene, advice), HasSubstr("no statement at 0.0001"));
}

TEST(Advice, NothingIsSaidWhereNothingMovesOrFrictionFallsBetweenSteps) {
  Scene still = springScene(6.3);
  still.model.nodes[1].x = {1.0, 0.0, 0.0};
  EXPECT_EQ(advise(still, {.tolerance = 1e-3, .budget = 2.0}).refusal, "nothing moves");
  EXPECT_THAT(advise(shipped("jelly_box"), {.tolerance = 1e-2, .budget = 2.0}).refusal, HasSubstr("set events = true"));
}

TEST(Advice, TheBudgetIsKeptAndSaid) {
  // The reference of this scene takes longer.
  const Scene scene = shipped("damping_dominated_cloth");
  const Advice advice = advise(scene, {.tolerance = 1e-3, .budget = 0.05});
  EXPECT_EQ(advice.chosen(), nullptr);
  EXPECT_THAT(advice.refusal, HasSubstr("give a larger --budget"));
  EXPECT_LT(advice.seconds, 1.0);
}

TEST(Advice, OptionsThatMakeNoSenseAreNamed) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double tolerance : {0.0, -1e-3, 1.5, nan}) {
    try {
      advise(springScene(6.3), {.tolerance = tolerance});
      ADD_FAILURE() << tolerance;
    } catch (const std::invalid_argument& error) {
      EXPECT_THAT(error.what(), HasSubstr("--tolerance is"));
    }
  }
  EXPECT_THROW(advise(springScene(6.3), {.tolerance = 1e-3, .budget = 0.0}), std::invalid_argument);
  EXPECT_THROW(advise(springScene(6.3), {.tolerance = 1e-3, .budget = nan}), std::invalid_argument);
}

/// Contact, friction with events, rods, a moved node: whatever a scene has, its run is as exact as was said, or there
/// is a reason.
TEST(Advice, ShippedScenesGetAChoiceOrAReason) {
  for (const char* name :
       {"bouncing_ball", "dumbbell", "elastic_pendulum", "hanging_chain", "oscillator", "triangle", "whip"}) {
    const Scene scene = shipped(name);
    const Advice advice = advise(scene, {.tolerance = 1e-3, .budget = 60.0});
    ASSERT_NE(advice.chosen(), nullptr) << name << ": " << advice.refusal;
    EXPECT_LE(advice.chosen()->error, 1e-3) << name;
    EXPECT_EQ(advice.scene.method, advice.chosen()->setting.method) << name;
    EXPECT_THAT(adviceText(scene, advice), HasSubstr("chosen")) << name;
    EXPECT_THAT(adviceText(scene, advice), ::testing::Not(HasSubstr("nan"))) << name;
  }
}

TEST(Advice, TheFigureShowsTheMethodsAndTheWayDown) {
  const Scene scene = shipped("dumbbell");
  const Advice advice = advise(scene, {.tolerance = 1e-3, .budget = 60.0});
  ASSERT_FALSE(advice.ladder.empty()) << adviceText(scene, advice);
  EXPECT_EQ(advice.ladder.front().left, "whole model");
  EXPECT_EQ(advice.ladder.size(), advice.leftOut().size() + 1);
  const Figure figure = figureOf(scene, advice);
  ASSERT_EQ(figure.panels().size(), 2U);
  const std::string best = advice.whole.chosen()->setting.name();
  EXPECT_TRUE(std::ranges::any_of(figure.panels()[0].series, [&](const Series& s) { return s.name == best; })) << best;
  EXPECT_TRUE(std::ranges::any_of(figure.panels()[1].series, [](const Series& s) { return s.name == "whole model"; }));
}

}  // namespace
}  // namespace muelle::lab
