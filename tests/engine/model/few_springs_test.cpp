#include "sample_models.h"

#include <gtest/gtest.h>
#include <cmath>
#include <string>

namespace muelle::engine::testing {
namespace {

/// A fan of springs from a held node and from node to node, with both dampings where asked for. Lengths, stiffnesses
/// and velocities are all different.
Model fan(int dimension, int springs, double relative, double projected) {
  Model model;
  model.dimension = dimension;
  model.gravity = dimension == 1 ? Vec3(-9.81, 0, 0) : dimension == 2 ? Vec3(0.3, 0, -9.81) : Vec3(0.3, 0.2, -9.81);
  model.nodes = {{.pinned = true}};
  for (int i = 1; i <= springs; ++i) {
    const double s = i;
    model.nodes.push_back({.x = {1.1 * s, 0.3 * std::sin(s), -0.4 * std::cos(2.0 * s)},
                           .v = {0.7 * std::cos(s), -0.2 * s, 0.1 + 0.05 * s},
                           .m = 0.5 + 0.1 * s});
    ModelSpring spring{.a = i % 3 == 0 ? 0 : i - 1, .b = i, .k = 90.0 + 7.0 * s, .L0 = 0.8 + 0.01 * s};
    spring.dRelative = relative * s;
    spring.dProjected = projected * s;
    model.springs.push_back(spring);
  }
  return model;
}

class FewSpringsOf : public ::testing::TestWithParam<int> {};

TEST_P(FewSpringsOf, AccelerateToTheLastBitAsTheirForcesSay) {
  for (const double relative : {0.0, 0.31}) {
    for (const double projected : {0.0, 0.17}) {
      for (const int count : {1, 2, 7, 8, 9, 12}) {
        const auto system = build(fan(GetParam(), count, relative, projected));
        State s = system->initialState();
        for (const bool frozen : {false, true}) {  // springs of 1D are followed through zero length
          if (system->switching() != nullptr) system->switching()->commit(s, frozen);
          std::vector<double> f(s.x.size()), a(s.x.size());
          system->force(s.t, s.x, s.v, s.z, f);
          system->acceleration(s.t, s.x, s.v, s.z, a);
          for (std::size_t i = 0; i < a.size(); ++i) {
            EXPECT_EQ(a[i], f[i] * system->inverseMass()[i]) << count << " springs, lane " << i;
          }
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Dimension, FewSpringsOf, ::testing::Values(1, 2, 3),
                         [](const auto& dimension) { return std::to_string(dimension.param) + "D"; });

TEST(FewSprings, LeaveRoomForOtherForces) {
  Model model = fan(3, 2, 0.0, 0.0);
  const auto without = build(model);
  model.nodes[1].drag = 0.4;
  const auto with = build(model);
  const State s = with->initialState();
  std::vector<double> a(s.x.size()), b(s.x.size());
  without->acceleration(s.t, s.x, s.v, s.z, a);
  with->acceleration(s.t, s.x, s.v, s.z, b);
  const auto lane = static_cast<std::size_t>(with->lane(1, 0));
  EXPECT_NEAR(b[lane] - a[lane], -0.4 * model.nodes[1].v[0] / model.nodes[1].m, 1e-12);
}

}  // namespace
}  // namespace muelle::engine::testing
