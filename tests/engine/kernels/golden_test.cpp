/// \file
/// One number that holds the kernels to the last bit: the same on every instruction set, compiler and level of
/// optimisation. The case has sums, products, quotients and square roots alone, all of which IEEE 754 rounds in one
/// way.

#include "oracle.h"

#include "engine/kernels/grid_search.h"
#include "engine/kernels/grid_springs.h"
#include "engine/kernels/kernel_table.h"
#include "engine/kernels/spring_groups.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace muelle::engine::kernels {
namespace {

constexpr int side = 19;
constexpr std::size_t clothNodes = side * side;
constexpr double step = 1.0 / 1024.0;
constexpr PlaneObstacle ground = {{0.0, 0.0, 1.0}, {0.0, 0.0, -0.125}, {0.0, 0.0, 0.25}, 512.0, 1.0};

/// A cloth of 361 nodes, two corners held, thrown by small random integers at a plane that moves up.
struct Cloth {
  Nodes nodes;
  std::vector<SpringData> springs;
  std::vector<double> inverseMass = std::vector<double>(clothNodes, 64.0);
};

Cloth goldenCloth() {
  Cloth cloth;
  Dice dice(2026);
  for (int i = 0; i < side; ++i) {
    for (int j = 0; j < side; ++j) {
      const double bump = dice.roll(64) / 1024.0;
      cloth.nodes.x.insert(cloth.nodes.x.end(), {i / 16.0, j / 16.0, bump});
      for (int c = 0; c < 3; ++c) cloth.nodes.v.push_back((dice.roll(257) - 128) / 64.0);
      const auto add = [&](int down, int right, double L0, double relative, double projected) {
        if (i + down >= side || j + right >= side || j + right < 0) return;
        const double k = 96.0 + dice.roll(64);
        cloth.springs.push_back({i * side + j, (i + down) * side + j + right, k, L0, relative, projected});
      };
      add(1, 0, 0.0625, 0.0, 0.0);
      add(0, 1, 0.0625, 0.0, 0.0);
      add(1, 1, 0.09375, 0.0, 0.25);
      add(1, -1, 0.09375, 0.125, 0.25);
      add(2, 0, 0.125, 0.125, 0.0);
      add(0, 2, 0.0, 0.125, 0.0);
    }
  }
  cloth.inverseMass[0] = cloth.inverseMass[side - 1] = 0.0;
  return cloth;
}

std::uint64_t hashOf(std::uint64_t hash, const std::vector<double>& values) {
  for (const double value : values) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    for (int i = 0; i < 8; ++i) hash = (hash ^ (bits >> (8 * i) & 0xFF)) * 1099511628211ULL;  // FNV-1a
  }
  return hash;
}

/// Symplectic Euler, 100 steps; `accelerate` writes a.
template <class Accelerate>
void run(std::vector<double>& x, std::vector<double>& v, std::vector<double>& a, Accelerate accelerate) {
  for (int n = 0; n < 100; ++n) {
    accelerate();
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double change = step * a[i];
      v[i] += change;
      if (a[i] == 0.0) v[i] = 0.0;  // a held node, or padding
      const double way = step * v[i];
      x[i] += way;
    }
  }
}

std::uint64_t hashOfPadded(std::uint64_t hash, const Cloth& cloth) {
  std::vector<double> x(4 * clothNodes), v(x.size()), a(x.size()), inverse(x.size()), drag(x.size());
  for (std::size_t i = 0; i < 3 * clothNodes; ++i) {
    const std::size_t lane = i / 3 * 4 + i % 3;
    x[lane] = cloth.nodes.x[i];
    v[lane] = cloth.nodes.v[i];
    inverse[lane] = cloth.inverseMass[i / 3];
    drag[lane] = 1.0 / 256.0;
  }
  const SpringGroups springs(3, static_cast<int>(clothNodes), cloth.springs);
  run(x, v, a, [&] {
    std::fill(a.begin(), a.end(), 0.0);
    springs.addForce(x.data(), v.data(), a.data());
    kernels().paddedContact[2](ground, {clothNodes, x.data(), v.data(), nullptr, a.data()});
    kernels().paddedPass[2]({a.data(), a.data(), v.data(), drag.data(), inverse.data(), {0.0, 0.5, -9.75}}, x.size());
  });
  return hashOf(hashOf(hash, x), v);
}

std::uint64_t hashOfPlanar(std::uint64_t hash, const Cloth& cloth, Precision precision) {
  PlanarCase planar(cloth.nodes);
  std::vector<double> inverse(planar.plane), drag(planar.plane);
  for (std::size_t i = 0; i < clothNodes; ++i) {
    inverse[i] = cloth.inverseMass[i];
    drag[i] = 1.0 / 256.0;
  }
  const GridSearch found = findRuns(3, clothNodes, cloth.springs);
  const GridSprings springs(3, clothNodes, found.runs, found.loose, 64, precision);
  run(planar.x, planar.v, planar.out, [&] {
    const PlanarFinish finish = {planar.out.data(), planar.plane,   nullptr, planar.v.data(),
                                 drag.data(),       inverse.data(), nullptr, {0.0, 0.5, -9.75}};
    springs.evaluate(planar.state(), finish);
    kernels().planarContact[2](
        ground, {clothNodes, planar.plane, planar.x.data(), planar.v.data(), inverse.data(), planar.out.data()});
  });
  return hashOf(hashOf(hash, planar.x), planar.v);
}

constexpr std::uint64_t start = 14695981039346656037ULL;  // of FNV-1a

TEST(GoldenHash, IsTheSameOnEveryInstructionSet) {
  const Cloth cloth = goldenCloth();
  onEveryInstructionSet([&](const std::string& set) {
    const std::uint64_t hash = hashOfPlanar(hashOfPadded(start, cloth), cloth, Precision::Double);
    EXPECT_EQ(hash, 0x437B2A56D7AE4781ULL) << set;
    EXPECT_EQ(hashOfPlanar(start, cloth, Precision::Single), 0xB4A5999C5A6CD383ULL) << set << ", single precision";
  });
}

}  // namespace
}  // namespace muelle::engine::kernels
