/// \file
/// Springs of grids in single precision: how far they are from the exact forces, and that they are the same on every
/// instruction set, wherever the scene lies and whatever was computed before.

#include "oracle.h"

#include "engine/kernels/grid_search.h"
#include "engine/kernels/grid_springs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

namespace muelle::engine::kernels {
namespace {

std::vector<double> singleForces(const Nodes& nodes, const std::vector<SpringData>& springs, std::size_t block = 0) {
  return gridForces(nodes, springs, block, Precision::Single);
}

/// The unit of FixedWindow for these numbers: 2^-30 of the power of two above the farthest from the first node.
double unitOf(const std::vector<double>& values, int dimension) {
  double far = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    far = std::max(far, std::fabs(values[i] - values[i % static_cast<std::size_t>(dimension)]));
  }
  int exponent = 0;
  std::frexp(far, &exponent);
  return std::ldexp(1.0, exponent - 30);
}

/// A coordinate is off by half a unit, a difference by a unit a component, sqrt(3) of it along any direction:
/// elongation and direction then change the elastic force by k (1 + |L0 - L| / L) of that, the projected one by 2
/// dProjected |w| / L. The operations in floats are those of which roundingBounds() counts 32 u, here of u = 2^-24, and
/// a node's sum of n forces rounds n times. First order in the unit over L, which is below 1e-5 here: 1.01 covers the
/// rest.
std::vector<double> singleBounds(const Nodes& nodes, const std::vector<SpringData>& springs) {
  const auto D = static_cast<std::size_t>(nodes.dimension);
  const double u = std::ldexp(1.0, -24), x = std::sqrt(3.0) * unitOf(nodes.x, nodes.dimension),
               v = std::sqrt(3.0) * unitOf(nodes.v, nodes.dimension);
  std::vector<double> bound(nodes.count()), size(nodes.count());
  std::vector<int> ends(nodes.count());
  for (const SpringData& s : springs) {
    double square = 0.0, speed = 0.0;
    for (std::size_t c = 0; c < D; ++c) {
      square +=
          std::pow(nodes.x[D * static_cast<std::size_t>(s.a) + c] - nodes.x[D * static_cast<std::size_t>(s.b) + c], 2);
      speed +=
          std::pow(nodes.v[D * static_cast<std::size_t>(s.a) + c] - nodes.v[D * static_cast<std::size_t>(s.b) + c], 2);
    }
    const double L = std::sqrt(square), w = std::sqrt(speed), off = std::fabs(s.L0 - L);
    const double rounding = 32.0 * u * (s.k * (L + off) + (s.dRelative + s.dProjected) * w);
    const double place = x * (s.k * (1.0 + off / L) + 2.0 * s.dProjected * w / L) + v * (s.dRelative + s.dProjected);
    for (const int end : {s.a, s.b}) {
      bound[static_cast<std::size_t>(end)] += 1.01 * (rounding + place);
      size[static_cast<std::size_t>(end)] += s.k * off + (s.dRelative + s.dProjected) * w;
      ++ends[static_cast<std::size_t>(end)];
    }
  }
  for (std::size_t i = 0; i < bound.size(); ++i) bound[i] += ends[i] * u * size[i];
  return bound;
}

TEST(SinglePrecision, IsAsFarFromTheExactForcesAsItsDigitsSay) {
  onEveryInstructionSet([](const std::string& set) {
    for (const int dimension : {2, 3}) {
      for (const Damping damping : everyDamping) {
        SCOPED_TRACE(set + ", " + std::to_string(dimension) + "D, damping " +
                     std::to_string(static_cast<int>(damping)));
        Dice dice(31);
        const Nodes sheet = randomNodes(dimension, 41 * 41, dice);
        const std::vector<SpringData> springs = clothSprings(41, damping, dice);
        const std::vector<long double> exact = oracleForces(sheet, springs);
        const std::vector<double> bound = singleBounds(sheet, springs), f = singleForces(sheet, springs);
        double largest = 0.0;
        for (std::size_t i = 0; i < f.size(); ++i) {
          const auto off = static_cast<double>(std::fabs(f[i] - exact[i]));
          ASSERT_LE(off, bound[i / static_cast<std::size_t>(dimension)]) << "number " << i;
          largest = std::max(largest, off);
        }
        EXPECT_GT(largest, 1e-7) << "these are doubles";
      }
    }
  });
}

TEST(SinglePrecision, IsTheSameOnEveryInstructionSetAndInBlocksOfAnySize) {
  for (const Damping damping : everyDamping) {
    Dice dice(32);
    const Nodes sheet = randomNodes(3, 29 * 29, dice);
    const std::vector<SpringData> springs = clothSprings(29, damping, dice);
    const std::vector<double> first = singleForces(sheet, springs);
    onEveryInstructionSet([&](const std::string& set) {
      for (const std::size_t block : {std::size_t{0}, std::size_t{8}, std::size_t{32}, std::size_t{88}}) {
        EXPECT_TRUE(areSame(first, singleForces(sheet, springs, block))) << set << ", blocks of " << block;
      }
    });
  }
}

TEST(SinglePrecision, OfOneMaterialIsThatOfEqualMaterialsEach) {
  Dice dice(33);
  const Nodes sheet = randomNodes(3, 21 * 21, dice);
  std::vector<SpringData> springs = clothSprings(21, Damping::None, dice);
  for (SpringData& s : springs) s = {s.a, s.b, 75.0, 0.5, 0.75, 1.5};
  GridSearch found = findRuns(3, 441, springs);
  for (GridRun& run : found.runs) {
    ASSERT_TRUE(run.isConstant);
    run.isConstant = false;
    for (std::vector<double>* values : {&run.k, &run.L0, &run.dRelative, &run.dProjected}) {
      values->assign(run.end - run.begin, values->front());
    }
  }
  onEveryInstructionSet([&](const std::string& set) {
    const std::vector<double> f = singleForces(sheet, springs);
    PlanarCase each(sheet);
    GridSprings(3, 441, found.runs, {}, 0, Precision::Single).evaluate(each.state(), each.finish());
    for (std::size_t i = 0; i < f.size(); ++i) ASSERT_EQ(each.at(i / 3, i % 3), f[i]) << set << ", number " << i;
  });
}

TEST(SinglePrecision, IsTheSameAThousandKilometresAway) {
  Dice dice(34);
  Nodes sheet = randomNodes(3, 20 * 20, dice);
  const std::vector<SpringData> springs = clothSprings(20, Damping::Both, dice);
  const std::vector<double> here = singleForces(sheet, springs);
  for (double& x : sheet.x) x += 1048576.0;  // exact: the numbers are multiples of 2^-20
  for (double& v : sheet.v) v -= 4096.0;
  EXPECT_TRUE(areSame(here, singleForces(sheet, springs)));
}

TEST(SinglePrecision, DependsOnNothingThatWasComputedBefore) {
  Dice dice(35);
  const Nodes sheet = randomNodes(3, 20 * 20, dice);
  const std::vector<SpringData> springs = clothSprings(20, Damping::Both, dice);
  const GridSearch found = findRuns(3, 400, springs);
  const GridSprings grid(3, 400, found.runs, found.loose, 64, Precision::Single);
  for (const double scale : {1.0, 1024.0, 0.25, 1e30, 0.375, 1e-3}) {
    Nodes other = sheet;
    for (double& x : other.x) x *= scale;
    for (double& v : other.v) v *= scale;
    const std::vector<double> alone = singleForces(other, springs, 64);
    PlanarCase planar(other);
    grid.evaluate(planar.state(), planar.finish());
    for (std::size_t i = 0; i < alone.size(); ++i) ASSERT_EQ(planar.at(i / 3, i % 3), alone[i]) << "scale " << scale;
  }
}

TEST(SinglePrecision, GivesWayToDoubleBeyondTheRangeOfFloats) {
  Dice dice(36);
  const Nodes sheet = randomNodes(3, 20 * 20, dice);
  const std::vector<SpringData> springs = clothSprings(20, Damping::Both, dice);
  for (const double scale : {1e-12, 1e13, 1e100}) {
    Nodes other = sheet;
    for (double& x : other.x) x *= scale;
    EXPECT_TRUE(areSame(gridForces(other, springs), singleForces(other, springs))) << scale;
  }
  std::vector<SpringData> stiff = springs;
  stiff.back().k = 1e30;
  EXPECT_TRUE(areSame(gridForces(sheet, stiff), singleForces(sheet, stiff)));
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    for (const std::size_t i : {0, 7, 1199}) {
      Nodes other = sheet;
      other.x[i] = bad;
      EXPECT_FALSE(std::isfinite(singleForces(other, springs)[i])) << i;
    }
  }
}

TEST(SinglePrecision, OfZeroLengthLeavesRelativeDampingAlone) {
  Nodes sheet = {3, std::vector<double>(3 * 25 * 25, 0.5), std::vector<double>(3 * 25 * 25, 0.0)};
  for (std::size_t i = 0; i < sheet.v.size(); ++i) sheet.v[i] = static_cast<double>(i % 7) / 4.0;
  sheet.x.back() = 1.0;  // one node elsewhere, so that there is a size
  Dice dice(37);
  for (const Damping damping : everyDamping) {
    const std::vector<SpringData> springs = clothSprings(25, damping, dice);
    const std::vector<double> full = gridForces(sheet, springs), single = singleForces(sheet, springs);
    // Coefficients are eighths, velocities quarters: floats have them exactly.
    for (std::size_t i = 0; i < 3 * 20 * 25; ++i) ASSERT_EQ(single[i], full[i]) << "number " << i;
  }
}

}  // namespace
}  // namespace muelle::engine::kernels
