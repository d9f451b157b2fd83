/// \file
/// Steel wires against the discrete catenary: the same springs and lumped weights, solved by shooting in 113 bits.

#include "engine/statics/rest.h"
#include "reference/binary128.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <ostream>
#include <vector>

namespace muelle::engine {
namespace {

using hard_cases::Quad;

constexpr double eps = std::numeric_limits<double>::epsilon();

/// How the wire is drawn before it hangs.
enum class Drawn { Straight, Sagging, Kinked };

struct Wire {
  int springs;
  double stiffness;  // EA over the weight
  double slack;      // rest length over span
  int dimension = 3;
  Drawn drawn = Drawn::Straight;
  double rise = 0.0;           // of the far hook over the near one [m]
  Vec3 origin = Vec3::Zero();  // the near hook
  double taper = 1.0;          // mass of the last node over that of the first
};

std::ostream& operator<<(std::ostream& out, const Wire& wire) {
  return out << wire.springs << " springs, EA / weight " << wire.stiffness << ", slack " << wire.slack << ", "
             << wire.dimension << "D, drawn " << static_cast<int>(wire.drawn) << ", rise " << wire.rise << ", from ("
             << wire.origin.transpose() << ")";
}

constexpr double g = 9.81;

double weightOf(const Model& model) {
  double sum = 0.0;
  for (const ModelNode& node : model.nodes) sum += node.pinned ? 0.0 : node.m * g;
  return sum;
}

Model modelOf(const Wire& wire) {
  Model model;
  model.dimension = wire.dimension;
  model.gravity = {0.0, 0.0, -g};
  const int n = wire.springs;
  for (int i = 0; i <= n; ++i) {
    const double s = static_cast<double>(i) / n;
    ModelNode node;
    node.x = wire.origin + Vec3(s, 0.0, wire.rise * s);
    if (wire.drawn == Drawn::Sagging) node.x[2] -= 2.0 * (wire.slack - 1.0) * s * (1.0 - s);
    if (wire.drawn == Drawn::Kinked && i % 2 == 1) node.x[2] += 0.1 / n;
    node.pinned = i == 0 || i == n;
    node.m = (1.0 + (wire.taper - 1.0) * s) / n;
    model.nodes.push_back(node);
  }
  const double weight = weightOf(model);
  for (int i = 0; i < n; ++i) {
    ModelSpring spring;
    spring.a = i;
    spring.b = i + 1;
    spring.L0 = wire.slack * std::hypot(1.0, wire.rise) / n;
    spring.k = wire.stiffness * weight / spring.L0;
    model.springs.push_back(spring);
  }
  return model;
}

/// Positions (x, z) of all nodes: t is the pull of the first spring on the near hook; each node adds its weight.
std::vector<std::array<Quad, 2>> hang(const Model& model, const std::array<Quad, 2>& first) {
  std::vector<std::array<Quad, 2>> at = {{Quad(model.nodes[0].x[0]), Quad(model.nodes[0].x[2])}};
  std::array<Quad, 2> t = first;
  for (std::size_t i = 0; i < model.springs.size(); ++i) {
    const ModelSpring& spring = model.springs[i];
    if (i > 0) t[1] += Quad(model.nodes[i].m) * Quad(g);
    const Quad T = sqrtq(t[0] * t[0] + t[1] * t[1]);
    const Quad length = Quad(spring.L0) + T / Quad(spring.k);
    at.push_back({at.back()[0] + length * t[0] / T, at.back()[1] + length * t[1] / T});
  }
  return at;
}

/// Shoots from the near hook to the far one: Newton's method on the first pull, with differences of 40 of the 113 bits.
std::vector<std::array<Quad, 2>> discreteCatenary(const Model& model, std::array<Quad, 2> pull) {
  const std::array<Quad, 2> far = {Quad(model.nodes.back().x[0]), Quad(model.nodes.back().x[2])};
  for (int i = 0; i < 60; ++i) {
    const auto end = hang(model, pull).back();
    const std::array<Quad, 2> miss = {end[0] - far[0], end[1] - far[1]};
    if (fabsq(miss[0]) + fabsq(miss[1]) < Quad(1e-28)) break;
    Quad J[2][2];
    for (std::size_t c = 0; c < 2; ++c) {
      auto moved = pull;
      const Quad step = ldexpq(fabsq(pull[0]) + fabsq(pull[1]), -50);
      moved[c] += step;
      const auto beside = hang(model, moved).back();
      for (std::size_t r = 0; r < 2; ++r) J[r][c] = (beside[r] - end[r]) / step;
    }
    const Quad det = J[0][0] * J[1][1] - J[0][1] * J[1][0];
    pull[0] -= (J[1][1] * miss[0] - J[0][1] * miss[1]) / det;
    pull[1] -= (J[0][0] * miss[1] - J[1][0] * miss[0]) / det;
  }
  return hang(model, pull);
}

/// Everything that is asked of a wire at rest.
void expectHangsAsTheCatenary(const Wire& wire) {
  SCOPED_TRACE(::testing::PrintToString(wire));
  const Model model = modelOf(wire);
  const double weight = weightOf(model), span = std::hypot(1.0, wire.rise);
  const auto system = build(model);
  const RestResult result = rest(*system);
  ASSERT_EQ(result.verdict, Verdict::Stable);
  EXPECT_LE(result.work.factorisations, 100);
  EXPECT_LE(result.residual, 1e-10 * weight);
  EXPECT_TRUE(result.isLowest);

  std::vector<Vec3> x;
  for (int i = 0; i <= wire.springs; ++i) x.push_back(system->position(result.state, i));
  const Vec3 first = result.tensions[0] * (x[1] - x[0]).normalized();
  const auto reference = discreteCatenary(model, {Quad(first[0]), Quad(first[2])});
  ASSERT_LT(static_cast<double>(fabsq(reference.back()[0] - Quad(x.back()[0]))), 1e-25) << "the shooting has missed";
  double farthest = 0.0, longest = 0.0, worst = 0.0, largest = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const auto dx = static_cast<double>(Quad(x[i][0]) - reference[i][0]);
    const auto dz = static_cast<double>(Quad(x[i][2]) - reference[i][1]);
    farthest = std::max(farthest, std::hypot(dx, x[i][1], dz));
    largest = std::max(largest, x[i].cwiseAbs().maxCoeff());
    if (i + 1 == x.size()) break;
    const Vec3 d = x[i + 1] - x[i];
    const ModelSpring& spring = model.springs[i];
    longest = std::max(longest, std::abs(d.norm() - spring.L0 - result.tensions[i] / spring.k));
    // The tension is that of the reference: its pull across the weight below it.
    const auto length = static_cast<double>(
        hypotq(reference[i + 1][0] - reference[i][0], reference[i + 1][1] - reference[i][1]) - Quad(spring.L0));
    if (wire.stiffness <= 1e6) worst = std::max(worst, std::abs(length * spring.k - result.tensions[i]));
  }
  EXPECT_LE(farthest, 1e-12 * span);
  // The last bit of both ends, in each of up to three components.
  EXPECT_LE(longest, 4.0 * eps * std::max(largest, span));
  EXPECT_LE(worst, 1e-9 * weight);
}

class SteelWire : public ::testing::TestWithParam<int> {};

TEST_P(SteelWire, DrawnStraightAndSlackHangsAsTheCatenary) {
  for (const double stiffness : {1e2, 1e4, 1e6, 1e8, 1e10, 1e12}) {
    expectHangsAsTheCatenary({.springs = GetParam(), .stiffness = stiffness, .slack = 1.2});
  }
}

/// Drawn straight and a little too long it is pressed, by up to the elastic energy that its weight could give: (EA /
/// weight) times the square of the surplus about 1. A saddle stands beside its start then, bent by a hair; it does not
/// stay there.
TEST_P(SteelWire, DrawnStraightAndALittleSlackHangsAsTheCatenary) {
  for (const double surplus : {1e-1, 1e-2, 1e-3, 1e-4, 1e-6}) {
    for (const double energy : {0.01, 0.1, 1.0}) {
      const double stiffness = std::clamp(energy / (surplus * surplus), 1e2, 1e12);
      expectHangsAsTheCatenary({.springs = GetParam(), .stiffness = stiffness, .slack = 1.0 + surplus, .dimension = 2});
    }
  }
}

TEST_P(SteelWire, TautHangsAsTheCatenary) {
  for (const double stiffness : {1e2, 1e6, 1e9, 1e12}) {
    expectHangsAsTheCatenary({.springs = GetParam(), .stiffness = stiffness, .slack = 1.0, .dimension = 2});
  }
}

TEST_P(SteelWire, FiveTimesAsLongAsItsSpanHangsAsTheCatenary) {
  for (const double stiffness : {1e2, 1e12}) {
    expectHangsAsTheCatenary({.springs = GetParam(), .stiffness = stiffness, .slack = 5.0});
  }
}

TEST_P(SteelWire, DrawnSaggingOrKinkedHangsAsTheCatenary) {
  for (const Drawn drawn : {Drawn::Sagging, Drawn::Kinked}) {
    for (const double stiffness : {1e3, 1e12}) {
      expectHangsAsTheCatenary({.springs = GetParam(), .stiffness = stiffness, .slack = 1.1, .drawn = drawn});
    }
  }
}

TEST_P(SteelWire, BetweenHooksOfTwoHeightsFarFromTheOriginHangsAsTheCatenary) {
  for (const double stiffness : {1e2, 1e7, 1e12}) {
    expectHangsAsTheCatenary({.springs = GetParam(),
                              .stiffness = stiffness,
                              .slack = 1.3,
                              .rise = 0.7,
                              .origin = {20.0, 0.0, -3.0},
                              .taper = 0.2});
  }
}

INSTANTIATE_TEST_SUITE_P(Springs, SteelWire, ::testing::Values(10, 100, 1000), ::testing::PrintToStringParamName());

/// The eigenvalue of a taut string's sideways motion is known: T/l times 4 sin^2(pi / 2n).
TEST(SteelWireEigenvalue, OfATautStringIsTheClosedForm) {
  for (const double stiffness : {1e4, 1e9, 1e12}) {
    Model model = modelOf({.springs = 50, .stiffness = stiffness, .slack = 1.0});
    model.gravity.setZero();
    for (ModelSpring& spring : model.springs) spring.L0 -= 30.0 / spring.k;
    const auto system = build(model);
    const RestResult result = rest(*system);
    ASSERT_EQ(result.verdict, Verdict::Stable) << stiffness;
    const double half = std::sin(std::numbers::pi / 100.0);
    const double expected = 30.0 * 50.0 * 4.0 * half * half;
    // L0 is rounded to a part in 1e16, of which the tension is EA times as much.
    const double tensionError = stiffness * g * eps * 4.0 / 30.0;
    EXPECT_NEAR(result.smallestEigenvalue / expected, 1.0, 1e-9 + tensionError) << stiffness;
  }
}

}  // namespace
}  // namespace muelle::engine
