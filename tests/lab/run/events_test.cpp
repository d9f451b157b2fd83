#include "lab/run/run_scene.h"
#include "support/scene_text.h"

#include <gtest/gtest.h>

namespace muelle::lab {

using namespace engine;
namespace {

TEST(Events, SayWhichWay) {
  Scene scene = sceneFrom(
      "title = 'A test'\nshows = 'nothing'\nslide = 'Contacto Externo'\ndimension = 1\ngravity = 9.81\n"
      "[[node]]\nx = 0.1\nm = 1.0\n[[obstacle]]\nshape = 'plane'\nname = 'ground'\npoint = 0.0\nk = 1e4\n" +
      engine::run);
  scene.step = 1e-3;
  const SceneRun result = runScene(scene);
  ASSERT_GE(result.result.events.size(), 4U);
  for (std::size_t i = 0; i < result.result.events.size(); ++i) {
    EXPECT_EQ(result.result.events[i].what, i % 2 == 0 ? "node 0 touches 'ground'" : "node 0 leaves 'ground'") << i;
  }
}

TEST(Events, OfAOneSidedSpringSayWhetherItPushes) {
  Scene scene = sceneFrom(head +
                          "[[node]]\nx = 0.0\npinned = true\n[[node]]\nx = 1.2\nv = -1.0\nm = 1.0\n"
                          "[[spring]]\nnodes = [0, 1]\nk = 1e3\nL0 = 1.0\nunilateral = true\n" +
                          engine::run);
  scene.step = 1e-3;
  const SceneRun result = runScene(scene);
  ASSERT_EQ(result.result.events.size(), 2U);
  EXPECT_EQ(result.result.events[0].what, "spring 0 begins to push at its rest length");
  EXPECT_EQ(result.result.events[1].what, "spring 0 lets go at its rest length");
}

}  // namespace
}  // namespace muelle::lab
