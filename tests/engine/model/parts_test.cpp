#include "engine/model/parts.h"
#include "sample_models.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <algorithm>
#include <limits>

namespace muelle::engine::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::vector<std::string> namesOf(const Model& model) {
  std::vector<std::string> names;
  for (const ModelPart& part : partsOf(model)) names.push_back(part.name);
  return names;
}

/// Six nodes with every kind of element and two parts of springs, all of which push or pull.
Model everyKind() {
  Model model = sixNodes(3, 7);
  for (ModelNode& node : model.nodes) node.drag = 0.3;
  model.parts = {"net.structural", "net.bend"};
  model.springs = {{.a = 0, .b = 1, .k = 30.0, .L0 = 0.8, .dProjected = 0.4, .part = 0},
                   {.a = 1, .b = 2, .k = 20.0, .L0 = 0.9, .dRelative = 0.2, .part = 0},
                   {.a = 0, .b = 3, .k = 10.0, .L0 = 0.5, .part = 1},
                   {.a = 4, .b = 5, .k = 15.0, .L0 = 2.0}};
  model.angles = {{0, 1, 3, 2.0, 0.3, 1}, {1, 3, 4, 3.0, 0.2}};
  model.dihedrals = {{0, 1, 3, 4, 2.0, 0.1}};
  model.areas = {{.nodes = {0, 1, 4}, .k = 5.0, .A0 = 0.2}};
  model.volumes = {{0, 1, 3, 4, 6.0, 0.4}};
  model.properties = {{.nodes = {0, 1, 5}, .weights = {up(3), up(3), up(3)}, .k = 4.0, .p0 = 0.3}};
  model.externalForces = {{.nodes = {1, 4}, .force = [](double, int) { return Vec3(0.3, -0.2, 0.1); }, .times = {}}};
  Obstacle ground;
  ground.centre = Vec3(0, 0, 0.4);
  ground.material.k = 50.0;
  model.obstacles = {ground};
  model.gravity = -9.81 * up(3);
  return model;
}

const std::vector<std::string> everyPart = {"net.structural", "net.bend", "spring",   "angle", "dihedral",
                                            "area",           "volume",   "property", "force", "obstacle ground",
                                            "gravity",        "drag"};

/// The force on each node's components, at the start; held nodes have 0.
std::vector<double> forcesByNode(const ModelSystem& system) {
  State state = system.initialState();
  if (system.switching() != nullptr) system.switching()->commit(state, false);
  std::vector<double> f = forceOf(system, state), byNode;
  for (int i = 0; i < system.nodeCount(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      const int lane = system.lane(i, axis);
      byNode.push_back(isFree(system.model().nodes[static_cast<std::size_t>(i)]) ? f[static_cast<std::size_t>(lane)]
                                                                                 : 0.0);
    }
  }
  return byNode;
}

TEST(Parts, HaveNamesAndCountWhatTheyEvaluate) {
  const Model model = everyKind();
  EXPECT_EQ(namesOf(model), everyPart);
  // Node 2 is pinned: five are free. A property goes through its nodes, a force through those it is on.
  std::vector<long long> elements;
  for (const ModelPart& part : partsOf(model)) elements.push_back(part.elements);
  EXPECT_THAT(elements, ElementsAre(2, 2, 1, 1, 1, 1, 1, 3, 2, 5, 5, 5));
}

TEST(Parts, AloneAddUpToTheWholeForce) {
  const Model model = everyKind();
  const std::vector<double> whole = forcesByNode(*build(model));
  std::vector<double> sum(whole.size(), 0.0), size(whole.size(), 0.0);
  for (const std::string& part : everyPart) {
    std::vector<std::string> others = everyPart;
    std::erase(others, part);
    const std::vector<double> own = forcesByNode(*build(model, others));
    EXPECT_TRUE(std::ranges::any_of(own, [](double f) { return std::abs(f) > 0.01; })) << part << " does nothing";
    for (std::size_t i = 0; i < sum.size(); ++i) {
      sum[i] += own[i];
      size[i] += std::abs(own[i]);
    }
  }
  for (std::size_t i = 0; i < sum.size(); ++i) {
    // Two sums of the same fewer than 32 terms in other orders: each addition rounds by at most eps / 2 of what there
    // is, in all 2 * 32 * eps / 2 of the sum of sizes.
    EXPECT_NEAR(sum[i], whole[i], 32.0 * std::numeric_limits<double>::epsilon() * size[i]);
  }
}

TEST(Parts, LeftOutAreAsIfTheyHadNeverBeenThere) {
  Model bare = everyKind();
  std::erase_if(bare.springs, [](const ModelSpring& spring) { return spring.part == 1; });
  std::erase_if(bare.angles, [](const ModelAngle& angle) { return angle.part == 1; });
  bare.gravity.setZero();
  bare.obstacles.clear();
  const auto expected = build(bare), found = build(everyKind(), {"obstacle ground", "net.bend", "gravity"});
  EXPECT_EQ(forcesByNode(*found), forcesByNode(*expected));
  EXPECT_EQ(found->totalEnergy(found->initialState()), expected->totalEnergy(expected->initialState()));
  EXPECT_EQ(namesOf(found->model()), namesOf(bare));
}

TEST(Parts, OfAnUnknownNameAreRefusedWithTheNamesThatThereAre) {
  const auto complaint = [](const Model& model, const std::string& name) {
    try {
      build(model, {name});
    } catch (const std::invalid_argument& fault) {
      return std::string(fault.what());
    }
    return std::string("accepted");
  };
  EXPECT_EQ(complaint(everyKind(), "net.bnd"), "there is no part 'net.bnd'; did you mean 'net.bend'?");
  EXPECT_THAT(complaint(everyKind(), "wind and weather"),
              HasSubstr("; there are net.structural, net.bend, spring, angle, "));
  EXPECT_EQ(complaint(sixNodes(3, 1), "spring"), "there is no part 'spring'; the model has no forces");
}

TEST(Parts, OfAnIndexThatIsNoneAreRefused) {
  Model model = everyKind();
  model.springs[3].part = 2;
  EXPECT_THROW(build(model), std::invalid_argument);
}

}  // namespace
}  // namespace muelle::engine::testing
