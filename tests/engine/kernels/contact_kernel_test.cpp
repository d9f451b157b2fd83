#include "oracle.h"

#include "engine/kernels/kernel_table.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace muelle::engine::kernels {
namespace {

/// A plane that goes through (1, 2, 3), its normal exactly of length 1 in any dimension.
PlaneObstacle slope(int dimension) {
  if (dimension == 1) return {{-1.0, 0.0, 0.0}, {0.5, 0.0, 0.0}, {0.25, 0.0, 0.0}, 16.0, 2.0};
  if (dimension == 2) return {{0.6, 0.8, 0.0}, {0.25, 0.5, 0.0}, {0.25, -1.0, 0.0}, 16.0, 2.0};
  return {{1.0 / 3.0, 2.0 / 3.0, -2.0 / 3.0}, {0.25, 0.5, 0.75}, {0.25, -1.0, 2.0}, 16.0, 2.0};
}

/// N = k depth - d w . n, one-sided, and its direction; what a component may err by is returned, too: ten roundings of
/// terms of at most k * 10 and d * 10.
double expectedForce(const PlaneObstacle& plane, const Nodes& nodes, std::size_t i, std::size_t c) {
  const auto D = static_cast<std::size_t>(nodes.dimension);
  long double depth = 0.0L, rate = 0.0L;
  for (std::size_t k = 0; k < D; ++k) {
    depth -= (static_cast<long double>(nodes.x[D * i + k]) - plane.point[k]) * plane.normal[k];
    rate += (static_cast<long double>(nodes.v[D * i + k]) - plane.velocity[k]) * plane.normal[k];
  }
  if (depth <= 0.0L) return 0.0;
  return static_cast<double>(std::max(0.0L, plane.k * depth - plane.d * rate) * plane.normal[c]);
}
constexpr double contactRounding = 10 * 1.1e-16 * (16.0 * 10 + 2.0 * 10);

Nodes cloud(int dimension, int count) {
  Dice dice(31);
  Nodes nodes;
  nodes.dimension = dimension;
  for (int i = 0; i < dimension * count; ++i) {
    nodes.x.push_back(2.0 * dice.number());
    nodes.v.push_back(9.0 * dice.number());
  }
  return nodes;
}

TEST(PlaneContact, PushesWhatIsBelowAndNeverPulls) {
  onEveryInstructionSet([](const std::string& set) {
    for (const int dimension : {1, 2, 3}) {
      for (const int count : {1, 3, 8, 9, 77}) {
        const Nodes nodes = cloud(dimension, count);
        const auto D = static_cast<std::size_t>(dimension), lanes = D == 3 ? 4 : D;
        const PlaneObstacle plane = slope(dimension);
        PlanarCase planar(nodes);
        std::fill(planar.out.begin(), planar.out.end(), 1.0);
        kernels().planarContact[D - 1](
            plane, {nodes.count(), planar.plane, planar.x.data(), planar.v.data(), nullptr, planar.out.data()});
        std::vector<double> x(lanes * nodes.count()), v(x.size()), f(x.size(), 1.0);
        for (std::size_t i = 0; i < nodes.x.size(); ++i) {
          x[i / D * lanes + i % D] = nodes.x[i];
          v[i / D * lanes + i % D] = nodes.v[i];
        }
        kernels().paddedContact[D - 1](plane, {nodes.count(), x.data(), v.data(), nullptr, f.data()});
        for (std::size_t i = 0; i < nodes.count(); ++i) {
          for (std::size_t c = 0; c < D; ++c) {
            const double expected = 1.0 + expectedForce(plane, nodes, i, c);
            EXPECT_NEAR(planar.at(i, c), expected, contactRounding) << set << ", node " << i;
            EXPECT_EQ(planar.at(i, c), f[lanes * i + c]) << set << ", node " << i;
          }
        }
      }
    }
  });
}

TEST(PlaneContact, GivesAccelerationsWhereItIsGivenMasses) {
  const Nodes nodes = cloud(3, 40);
  const PlaneObstacle plane = slope(3);
  onEveryInstructionSet([&](const std::string& set) {
    PlanarCase planar(nodes);
    std::fill(planar.out.begin(), planar.out.end(), 0.0);
    std::vector<double> inverse(planar.plane, 0.25);
    inverse[7] = 0.0;
    kernels().planarContact[2](
        plane, {nodes.count(), planar.plane, planar.x.data(), planar.v.data(), inverse.data(), planar.out.data()});
    for (std::size_t i = 0; i < nodes.count(); ++i) {
      const double expected = i == 7 ? 0.0 : 0.25 * expectedForce(plane, nodes, i, 2);
      EXPECT_NEAR(planar.at(i, 2), expected, contactRounding) << set << ", node " << i;
    }
  });
}

}  // namespace
}  // namespace muelle::engine::kernels
