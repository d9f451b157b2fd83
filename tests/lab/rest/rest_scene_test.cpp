#include "lab/rest/rest_scene.h"

#include "lab/rest/rest_figure.h"

#include <gmock/gmock.h>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <stdexcept>

namespace muelle::lab {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

engine::Scene shipped(const std::string& name) {
  return engine::readScene(std::filesystem::path(MUELLE_SCENES) / (name + ".toml"));
}

/// What hangs or stands is stable; what flies freely, or lies on a smooth ground, costs nothing to move.
TEST(SceneAtRest, ShippedScenesComeToWhatTheyMust) {
  const std::pair<const char*, engine::Verdict> expected[] = {
      {"bouncing_ball", engine::Verdict::Stable},
      {"column_at_rest", engine::Verdict::Stable},
      {"damping_dominated_cloth", engine::Verdict::Stable},
      {"dumbbell", engine::Verdict::Neutral},
      {"elastic_pendulum", engine::Verdict::Stable},
      {"hanging_chain", engine::Verdict::Stable},
      {"jelly_box", engine::Verdict::Neutral},
      {"oscillator", engine::Verdict::Stable},
      {"triangle", engine::Verdict::Neutral},
      {"whip", engine::Verdict::Stable},
  };
  for (const auto& [name, verdict] : expected) {
    const engine::Scene scene = shipped(name);
    const SceneAtRest rest = restScene(scene, {});
    EXPECT_EQ(nameOf(rest.result.verdict), nameOf(verdict)) << name;
    EXPECT_THAT(summaryOf(scene, rest), HasSubstr("verdict     " + nameOf(verdict))) << name;
  }
}

/// H09: the catenary of 20 springs. Statics of its halves: an end spring holds the weight of 9.5 nodes and the pull
/// across, which is that of the springs beside the middle node, each with half of that node's weight.
TEST(SceneAtRest, SummaryHasEigenvalueBalanceAndTensions) {
  const engine::Scene scene = shipped("hanging_chain");
  const SceneAtRest rest = restScene(scene, {});
  const std::string text = summaryOf(scene, rest);
  for (const char* part :
       {"eigenvalue  5.75836 N/m", "of the load of 18.64 N", "20 pull, 0 push", "energy      -4.3487948 J"}) {
    EXPECT_THAT(text, HasSubstr(part));
  }
  EXPECT_THAT(text, Not(HasSubstr("nan")));
  const double weight = 19 * 0.1 * 9.81;
  const double across = std::sqrt(std::pow(rest.result.tensions[9], 2.0) - std::pow(0.05 * 9.81, 2.0));
  EXPECT_NEAR(rest.result.tensions[0], std::hypot(0.5 * weight, across), 1e-12 * weight);
}

TEST(SceneAtRest, FigureShowsTheTensionsOfAllSprings) {
  const engine::Scene scene = shipped("hanging_chain");
  const SceneAtRest rest = restScene(scene, {});
  const Figure figure = figureOf(scene, rest);
  ASSERT_EQ(figure.panels().size(), 2U);
  EXPECT_EQ(figure.panels()[1].series[0].y, rest.result.tensions);
  const auto& series = figure.panels()[0].series;
  const auto names = [&](const char* name) {
    return std::ranges::any_of(series, [&](const Series& s) { return s.name == name; });
  };
  EXPECT_TRUE(names("pulls") && names("at the start"));
  EXPECT_FALSE(names("pushes"));
}

TEST(SceneAtRest, ATimeThatIsNoneIsRefused) {
  EXPECT_THROW(restScene(shipped("whip"), {.time = -1.0}), std::invalid_argument);
  EXPECT_THROW(restScene(shipped("whip"), {.time = std::numeric_limits<double>::quiet_NaN()}), std::invalid_argument);
}

}  // namespace
}  // namespace muelle::lab
