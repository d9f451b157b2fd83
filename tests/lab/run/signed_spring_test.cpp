/// \file
/// What a spring of 1D does beyond its anchor: by distance it pushes to the other side, and the run says so; a signed
/// one is the linear spring of the textbooks.

#include "lab/run/run_scene.h"
#include "support/scene_text.h"

#include <gmock/gmock.h>
#include <cmath>

namespace muelle::lab {

using namespace engine;
namespace {

/// 1 kg at 0.1 m, at -3 m/s, on a spring of 100 N/m and 0.2 m to the origin: it passes the anchor.
Scene through(const std::string& more) {
  Scene scene = sceneFrom(head + "[[node]]\nx = 0.0\npinned = true\n[[node]]\nx = 0.1\nv = -3.0\nm = 1.0\n" +
                          "[[spring]]\nnodes = [0, 1]\nk = 100.0\nL0 = 0.2\n" + more + engine::run);
  scene.method = "dop853";
  scene.tolerance = 1e-12;
  scene.duration = 2.0;
  return scene;
}

TEST(SignedSpring, SwingsAboutItsRestLengthThroughTheAnchor) {
  const SceneRun result = runScene(through("signed = true\n"));
  // x = 0.2 - 0.1 cos(10 t) - 0.3 sin(10 t), on one side and the other; within ten times the tolerance of 0.6 m.
  for (std::size_t i = 0; i < result.result.trajectory.t.size(); ++i) {
    const double t = result.result.trajectory.t[i];
    const double exact = 0.2 - 0.1 * std::cos(10.0 * t) - 0.3 * std::sin(10.0 * t);
    EXPECT_NEAR(result.result.trajectory.x[i][0], exact, 1e-11) << t;
  }
  EXPECT_EQ(result.result.work.events, 0);
}

// The energy 100 (L - 0.2)^2 / 2 + v^2 / 2 is kept by every method that keeps energies, discrete gradient included.
TEST(SignedSpring, HasTheEnergyOfItsForce) {
  Scene scene = through("signed = true\n");
  scene.method = "discrete_gradient";
  scene.tolerance.reset();
  scene.step = 0.01;
  const SceneRun result = runScene(scene);
  const std::vector<double>& E = result.result.trajectory.track("total energy");
  EXPECT_NEAR(E.front(), 5.0, 1e-14);                             // 100 (0.1)^2 / 2 + 9 / 2
  for (const double energy : E) EXPECT_NEAR(energy, 5.0, 1e-11);  // Newton's 1e-12 of the forces, 200 steps
}

TEST(SpringByDistance, SaysThatItPushesToTheOtherSide) {
  const SceneRun result = runScene(through(""));
  ASSERT_FALSE(result.result.events.empty());
  EXPECT_EQ(result.result.events[0].what,
            "spring 0 passes through zero length and pushes to the other side (signed = true: it does not)");
}

// A textbook's two masses on springs of signed lengths, from an independent integration (shared reference, 1e-6).
TEST(SignedSpring, EndsWhereTheTextbookDoes) {
  Scene scene = sceneFrom(head +
                          "[[node]]\nx = 0.0\npinned = true\n[[node]]\nx = 0.5\nm = 1.0\ndrag = 0.8\n"
                          "[[node]]\nx = 2.25\nm = 1.5\ndrag = 0.5\n"
                          "[[spring]]\nnodes = [0, 1]\nk = 8.0\nL0 = 0.5\nsigned = true\n"
                          "[[spring]]\nnodes = [1, 2]\nk = 40.0\nL0 = 1.0\nsigned = true\n" +
                          engine::run);
  scene.method = "dop853";
  scene.tolerance = 1e-11;
  scene.duration = 10.0;
  const SceneRun result = runScene(scene);
  EXPECT_NEAR(result.system->position(result.result.last, 1)[0], 0.508029, 1e-6);
  EXPECT_NEAR(result.system->position(result.result.last, 2)[0], 1.479934, 1e-6);
}

TEST(SignedSpring, NeedsASide) {
  EXPECT_THAT(
      complaintAbout("title = 'A'\nshows = 'n'\nslide = 's'\ndimension = 2\ngravity = 0.0\n[[node]]\nx = [0.0, 0.0]\n"
                     "pinned = true\n[[node]]\nx = [1.0, 0.0]\nm = 1.0\n[[spring]]\nnodes = [0, 1]\nk = 1.0\n"
                     "signed = true\n" +
                     engine::run),
      ::testing::HasSubstr("only a scene of dimension 1 has sides"));
}

}  // namespace
}  // namespace muelle::lab
