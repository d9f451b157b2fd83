#include "harness/function_system.h"
#include "harness/mesh.h"

#include <gtest/gtest.h>
#include <cmath>

namespace muelle {
namespace {

const ForceFunction nothing = [](double, In, In, Out) {};

TEST(FunctionSystem, AsksItsFunction) {
  const FunctionSystem system({1.0, 2.0}, [](double t, In x, In v, Out f) {
    f[0] = t + x[0];
    f[1] = 10 * v[1];
  });
  std::vector<double> f(2);
  system.force(0.5, std::vector<double>{1, 2}, std::vector<double>{3, 4}, {}, f);
  EXPECT_EQ(f, (std::vector<double>{1.5, 40}));
  EXPECT_EQ(system.size(), 2);
  EXPECT_EQ(system.mass()[1], 2.0);
}

TEST(FunctionSystem, RefusesMassesThatMakeNoSense) {
  for (const double mass : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    EXPECT_THROW(FunctionSystem({1.0, mass}, nothing), std::invalid_argument) << mass;
  }
  EXPECT_THROW(FunctionSystem({1.0}, nullptr), std::invalid_argument);
}

TEST(FlatArrays, HoldThreeEntriesANode) {
  Node a, b;
  a.x = Vec3(1, 2, 3);
  b.x = Vec3(4, 5, 6);
  b.v = Vec3(7, 8, 9);
  b.m = 2.0;
  const State state = stateOf({a, b});
  EXPECT_EQ(state.x, (std::vector<double>{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(state.v, (std::vector<double>{0, 0, 0, 7, 8, 9}));
  EXPECT_EQ(massesOf({a, b}), (std::vector<double>{1, 1, 1, 2, 2, 2}));
  EXPECT_EQ(node3(In(state.x), 1), b.x);
  std::vector<double> f(6);
  node3(Out(f), 1) = Vec3(1, 2, 3);
  EXPECT_EQ(f, (std::vector<double>{0, 0, 0, 1, 2, 3}));
}

TEST(FlatArrays, AreThoseOfAMeshWrittenOut) {
  const Mesh bar = {{{Vec3(0, 0, 0)}, {Vec3(0, 0, 1), Vec3(1, 0, 0), 2.0}}, {{0, 1, 100.0, 1.0}}};
  EXPECT_EQ(stateOf(bar.nodes).x, (std::vector<double>{0, 0, 0, 0, 0, 1}));
  EXPECT_EQ(stateOf(bar.nodes).v, (std::vector<double>{0, 0, 0, 1, 0, 0}));
  EXPECT_EQ(massesOf(bar.nodes), (std::vector<double>{1, 1, 1, 2, 2, 2}));
  EXPECT_EQ(bar.springs.front().L0, 1.0);
}

TEST(FlatArrays, RefusePinnedNodes) {
  Node pinned;
  pinned.pinned = true;
  EXPECT_THROW(stateOf({Node{}, pinned}), std::invalid_argument);
  EXPECT_THROW(massesOf({pinned}), std::invalid_argument);
}

}  // namespace
}  // namespace muelle
