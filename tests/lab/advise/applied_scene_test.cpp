#include "lab/advise/applied_scene.h"

#include "base/file.h"
#include "lab/advise/listed_scene.h"

#include <gmock/gmock.h>
#include <filesystem>
#include <stdexcept>

namespace muelle::lab {

using namespace engine;
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

/// An advice as if it had been given.
Advice adviceFor(const Scene& scene, const Setting& setting, const std::vector<Simplification>& parts) {
  Advice advice;
  advice.scene = withSetting(without(scene, parts), setting);
  Candidate chosen;
  chosen.fate = Candidate::Fate::Chosen;
  chosen.setting = setting;
  advice.methods.candidates = {chosen};
  for (const Simplification& part : parts) {
    PartTrial trial;
    trial.part = part;
    trial.leftOut = true;
    advice.parts.push_back(trial);
  }
  return advice;
}

/// The parts of these names.
std::vector<Simplification> named(const Scene& scene, const std::vector<std::string>& names) {
  std::vector<Simplification> parts;
  for (const Simplification& part : simplificationsOf(scene)) {
    if (std::ranges::find(names, part.name) != names.end()) parts.push_back(part);
  }
  EXPECT_EQ(parts.size(), names.size());
  return parts;
}

class Applied : public ::testing::Test {
 protected:
  fs::path write(const std::string& text) {
    const fs::path file = folder_.path() / "scene.toml";
    writeFile(file, text);
    return file;
  }
  fs::path target() const { return folder_.path() / "advised.toml"; }

  static constexpr const char* cloth = R"(title = "t"
shows = "s"
slide = "l"
gravity = 9.81
[[object]]
kind = "grid"
name = "cloth"      # of silk
nodes = [6, 6]
spacing = 0.1
mass = 0.1
k = 100.0
shear_stiffness = 50.0
bend_stiffness = 5.0
projected_damping = 0.01
drag = 1e-4
[[pin]]
object = "cloth"
nodes = [0, 5]
[[obstacle]]
shape = "plane"
name = "left"
point = [-5.0, 0.0, 0.0]
normal = [1.0, 0.0, 0.0]
k = 100.0

# what it lies on
[[obstacle]]
shape = "plane"
name = "ground"
point = [0.0, 0.0, -9.0]
k = 100.0
[run]
method = "velocity_verlet"   # as in the lecture
step = 1e-3
duration = 1.0
)";

  TemporaryFolder folder_{::testing::TempDir()};
};

TEST_F(Applied, MethodAndStepStandInPlaceOfTheScenes) {
  const fs::path file = write(cloth);
  const Scene scene = readScene(file);
  writeApplied(file, adviceFor(scene, {"dop853", false, 1e-5}, {}), target());
  const Scene read = readScene(target());
  EXPECT_EQ(read.method, "dop853");
  EXPECT_EQ(read.tolerance, 1e-5);
  EXPECT_FALSE(read.step.has_value());
  EXPECT_THAT(readFile(target()), HasSubstr("# of silk"));
  writeApplied(file, adviceFor(scene, {"velocity_verlet", true, 0.00123}, {}), target());
  EXPECT_EQ(readScene(target()).step, 0.00123);
}

TEST_F(Applied, PartsAreLeftOutOfTheFile) {
  const fs::path file = write(cloth);
  const Scene scene = readScene(file);
  const std::vector<Simplification> parts =
      named(scene, {"contact with 'left'", "damping of springs", "drag", "cloth.bend"});
  writeApplied(file, adviceFor(scene, {"nystrom8", false, 1e-5}, parts), target());
  const Scene read = readScene(target());
  ASSERT_EQ(read.model.obstacles.size(), 1U);
  EXPECT_EQ(read.model.obstacles[0].name, "ground");
  EXPECT_THAT(readFile(target()), HasSubstr("# what it lies on"));
  EXPECT_EQ(read.model.springs.size(), scene.model.springs.size() - 2U * 6U * 4U);
  for (const ModelSpring& spring : read.model.springs) EXPECT_EQ(spring.dProjected, 0.0);
  for (const ModelNode& node : read.model.nodes) EXPECT_EQ(node.drag, 0.0);
}

TEST_F(Applied, StillNodesArePinned) {
  const fs::path file = write(cloth);
  Simplification still{.kind = Simplification::Kind::Motion, .name = "motion of 2 still nodes"};
  still.nodes = {7, 9};
  writeApplied(file, adviceFor(readScene(file), {"dop853", false, 1e-5}, {still}), target());
  const Scene read = readScene(target());
  EXPECT_TRUE(read.model.nodes[7].pinned && read.model.nodes[9].pinned);
  EXPECT_FALSE(read.model.nodes[8].pinned);
}

TEST_F(Applied, DigitsAreAKeyOfTheScene) {
  const Simplification digits{.kind = Simplification::Kind::Digits, .name = "double precision"};
  const std::string said = cloth, title = said.substr(0, said.find('\n') + 1);
  for (const std::string& text : {said, title + "precision = \"double\"\n" + said.substr(title.size())}) {
    const fs::path file = write(text);
    writeApplied(file, adviceFor(readScene(file), {"nystrom8", false, 1e-5}, {digits}), target());
    EXPECT_EQ(readScene(target()).model.precision, kernels::Precision::Single);
    EXPECT_THAT(readFile(target()), HasSubstr("# of silk"));
  }
}

TEST_F(Applied, APlaneIsListedNodeByNode) {
  const fs::path file = write(R"(title = "a \"flat\" one"
shows = "s"
slide = "l"
gravity = 9.81
[[node]]
x = [0.1, 2.0, 0.0]
pinned = true
[[node]]
x = [0.1, 2.0, -1.0]
v = [0.3, 0.0, 0.0]
m = 2.5
drag = 0.125
[[spring]]
nodes = [0, 1]
k = 100.0
L0 = 0.3333333333333333
projected_damping = 0.5
[[obstacle]]
shape = "plane"
point = [0.0, 0.0, -3.0]
k = 50.0
mu = 0.25
[run]
method = "velocity_verlet"
step = 1e-3
duration = 1.0
[[output]]
kind = "position"
name = "height"
nodes = [1]
axis = "z"
)");
  const Scene scene = readScene(file);
  const AppliedScene applied =
      writeApplied(file, adviceFor(scene, {"runge_kutta_4", true, 2e-3}, named(scene, {"the y axis"})), target());
  EXPECT_TRUE(applied.notSaid.empty());
  const Scene read = readScene(target());
  EXPECT_EQ(read.title, scene.title);
  EXPECT_EQ(read.model.dimension, 2);
  EXPECT_EQ(read.model.plane, (std::array<int, 2>{0, 2}));
  EXPECT_EQ(read.model.gravity, scene.model.gravity);
  EXPECT_EQ(read.model.nodes[1].x, Vec3(0.1, 0.0, -1.0));
  EXPECT_EQ(read.model.nodes[1].v, Vec3(0.3, 0.0, 0.0));
  EXPECT_EQ(read.model.nodes[1].m, 2.5);
  EXPECT_EQ(read.model.nodes[1].drag, 0.125);
  EXPECT_EQ(read.model.springs[0].L0, scene.model.springs[0].L0);
  EXPECT_EQ(read.model.springs[0].dProjected, 0.5);
  EXPECT_EQ(read.model.obstacles[0].material.mu, 0.25);
  EXPECT_EQ(read.outputs.size(), 1U);
  EXPECT_EQ(read.step, 2e-3);
}

TEST_F(Applied, WhatAFileCannotSayIsTold) {
  Scene scene;
  scene.model.nodes.resize(1);
  EXPECT_EQ(unlisted(scene), "");
  scene.model.externalForces.resize(1);
  EXPECT_THAT(unlisted(scene), HasSubstr("forces"));
}

TEST_F(Applied, MeshesAreFoundFromTheNewFolder) {
  writeFile(folder_.path() / "roof.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n1 1 1\n3 0 1 2\n3 1 3 2\n");
  const fs::path file = write(R"(title = "t"
shows = "s"
slide = "l"
[[object]]
kind = "shell"
mesh = "roof.off"
mass = 1.0
k = 10.0
[run]
method = "velocity_verlet"
step = 1e-3
duration = 1.0
)");
  const fs::path elsewhere = folder_.path() / "deep" / "er";
  fs::create_directories(elsewhere);
  writeApplied(file, adviceFor(readScene(file), {"velocity_verlet", true, 1e-4}, {}), elsewhere / "advised.toml");
  EXPECT_EQ(readScene(elsewhere / "advised.toml").model.nodes.size(), 4U);
  EXPECT_THAT(readFile(elsewhere / "advised.toml"), HasSubstr("mesh = \"../../roof.off\""));
}

TEST_F(Applied, TheSceneItselfIsNotWrittenOver) {
  const fs::path file = write(cloth);
  const Advice advice = adviceFor(readScene(file), {"dop853", false, 1e-5}, {});
  EXPECT_THROW(writeApplied(file, advice, file), std::invalid_argument);
  EXPECT_THROW(writeApplied(file, advice, folder_.path() / "." / "scene.toml"), std::invalid_argument);
  EXPECT_THROW(writeApplied(file, advice, folder_.path() / "advised.txt"), std::invalid_argument);
  EXPECT_EQ(readFile(file), cloth);
}

}  // namespace
}  // namespace muelle::lab
