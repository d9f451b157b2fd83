/// \file
/// Single precision in place of double as a part of a model that may be left out: lab/advise/part_trial.h.

#include "lab/advise/part_trial.h"

#include "spring_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace muelle::lab {

using namespace engine;
namespace {

/// A square membrane of 12 by 12 nodes, its springs a tenth shorter at rest, held at its edge and struck in the middle.
Scene membrane() {
  constexpr int n = 12;
  Scene scene;
  scene.name = "membrane";
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      ModelNode node = {.x = {0.1 * i, 0.1 * j, 0.0}, .m = 0.01};
      node.pinned = i == 0 || j == 0 || i == n - 1 || j == n - 1;
      if (i == 5 && j == 6) node.v = {0.0, 0.0, 0.3};
      scene.model.nodes.push_back(node);
      if (j + 1 < n) scene.model.springs.push_back({.a = i * n + j, .b = i * n + j + 1, .k = 50.0, .L0 = 0.09});
      if (i + 1 < n) scene.model.springs.push_back({.a = i * n + j, .b = (i + 1) * n + j, .k = 50.0, .L0 = 0.09});
    }
  }
  scene.method = "velocity_verlet";
  scene.step = 0.002;
  scene.duration = 0.3;
  scene.outputInterval = 0.01;
  return scene;
}

std::vector<PartTrial> digitsOf(const Scene& scene, double tolerance, const Setting& timing) {
  const std::unique_ptr<ModelSystem> system = build(scene.model);
  const Pilots whole(scene, *system);
  const ReferenceMotion reference = findReference(whole, tolerance, 60.0);
  EXPECT_TRUE(reference.stands()) << reference.failure;
  std::vector<PartTrial> trials = tryParts(whole, reference, timing, tolerance, 60.0);
  std::erase_if(trials, [](const PartTrial& trial) { return trial.part.kind != Simplification::Kind::Digits; });
  return trials;
}

/// A run at tolerance 3e-7 differs from the reference by some hundred of that at most, where digits were the same;
/// those that are missing move a node by 1e-7 of its acceleration a step.
TEST(Digits, ThatAreMissingCostWhatARunWithoutThemSays) {
  const std::vector<PartTrial> trials = digitsOf(membrane(), 1e-3, {"dop853", false, 1e-5});
  ASSERT_EQ(trials.size(), 1U);
  EXPECT_TRUE(trials[0].measured);
  EXPECT_LT(trials[0].error, 1e-3 / 3.0) << trials[0].why;
  EXPECT_EQ(trials[0].leftOut, trials[0].timeLeft < 0.95) << trials[0].why;
}

/// At 1e-9 no run without them comes near.
TEST(Digits, AreKeptForErrorsBelowTheirRounding) {
  const std::vector<PartTrial> trials = digitsOf(membrane(), 1e-9, {"nystrom12", true, 0.001});
  ASSERT_EQ(trials.size(), 1U);
  EXPECT_FALSE(trials[0].leftOut);
  EXPECT_GT(trials[0].error, 1e-9);
}

TEST(Digits, AreNothingToLeaveOutWhereSpringsAreNoGridOrSingleAlready) {
  EXPECT_TRUE(digitsOf(springScene(1.0), 1e-3, {"dop853", false, 1e-5}).empty());
  Scene single = membrane();
  single.model.precision = kernels::Precision::Single;
  EXPECT_TRUE(digitsOf(single, 1e-2, {"velocity_verlet", true, 0.001}).empty());
}

}  // namespace
}  // namespace muelle::lab
