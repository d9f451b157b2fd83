/// \file
/// Motions in closed form: control/closed_form.h against the equations, and contacts that are taken so.

#include "engine/control/closed_form.h"
#include "engine/control/simulate.h"
#include "engine/integrators/catalogue.h"
#include "engine/model/model_system.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <functional>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

namespace muelle::engine {
namespace {

// --- one lane ---

struct Lane {
  double force, stiffness, damping, x, v;
};

/// By the two exponentials of the characteristic equation, in long double; not at critical damping.
struct Exact {
  long double x, v;
};
Exact exactly(const Lane& lane, double h) {
  using Complex = std::complex<long double>;
  const long double K = lane.stiffness, C = lane.damping, rest = lane.force / K;
  const Complex y = lane.x - rest, v = lane.v, after = h, half = -C / 2;
  const Complex root = std::sqrt(Complex(C * C / 4 - K, 0.0L)), p = half + root, q = half - root;
  const Complex a = (v - q * y) / (p - q), b = y - a;
  const Complex ofP = a * std::exp(p * after), ofQ = b * std::exp(q * after);
  return {rest + (ofP + ofQ).real(), (p * ofP + q * ofQ).real()};
}

State moved(const Lane& lane, double h) {
  const std::vector<double> force = {lane.force}, stiffness = {lane.stiffness}, damping = {lane.damping};
  const State from{0.0, {lane.x}, {lane.v}, {}};
  State to;
  moveInClosedForm(from, h, {force, stiffness, damping}, to);
  return to;
}

TEST(ClosedForm, SolvesTheOscillatorBelowAndAboveCriticalDamping) {
  for (const double damping : {0.0, 0.3, 19.0, 19.999999, 20.000001, 21.0, 100.0}) {
    const Lane lane = {-9.81, 100.0, damping, 0.3, -2.0};
    for (const double h : {1e-3, 0.05, 0.16, 1.0}) {
      const Exact exact = exactly(lane, h);
      const State to = moved(lane, h);
      // Sizes of 0.4 m and 4 m/s; near critical damping the oracle's own difference of roots costs it three digits.
      EXPECT_NEAR(to.x[0], static_cast<double>(exact.x), 4e-15) << damping << ", " << h;
      EXPECT_NEAR(to.v[0], static_cast<double>(exact.v), 4e-14) << damping << ", " << h;
    }
  }
}

TEST(ClosedForm, AtCriticalDampingIsThePolynomialTimesTheExponential) {
  const Lane lane = {5.0, 25.0, 10.0, 1.0, 3.0};
  for (const double h : {0.01, 0.3, 2.0}) {
    const double y = 0.8, slope = 3.0 + 5.0 * y;
    const State to = moved(lane, h);
    EXPECT_NEAR(to.x[0], 0.2 + (y + slope * h) * std::exp(-5.0 * h), 2e-15);
    EXPECT_NEAR(to.v[0], (3.0 - 5.0 * slope * h) * std::exp(-5.0 * h), 1e-14);
  }
}

TEST(ClosedForm, IncrementsOfShortTimesKeepTheirDigits) {
  const std::vector<double> force = {-9.81}, stiffness = {1e5}, damping = {30.0};
  const State from{0.0, {1.0}, {-4.0}, {}};
  for (const double h : {1e-6, 1e-9, 1e-12}) {
    State increment;
    closedFormIncrement(from, h, {force, stiffness, damping}, increment);
    // To the fourth derivative of x: what is left is below (h w)^3, w = 316 1/s, of the largest terms.
    const double a = -9.81 - 1e5 + 120.0, jerk = 4e5 - 30.0 * a, snap = -1e5 * a - 30.0 * jerk;
    const double left = std::pow(320.0 * h, 3) + 1e-14;
    EXPECT_NEAR(increment.x[0], h * (-4.0 + h * (a / 2.0 + h * (jerk / 6.0 + h * snap / 24.0))), 4.0 * h * left);
    EXPECT_NEAR(increment.v[0], h * (a + h * (jerk / 2.0 + h * snap / 6.0)), 1e5 * h * left);
  }
}

TEST(ClosedForm, OfAUniformForceIsTheParabola) {
  const State from{1.0, {2.0, -1.0}, {3.0, 0.0}, {7.0}};
  const std::vector<double> force = {-10.0, 4.0};
  State to;
  moveInClosedForm(from, 0.5, uniformMotion(force), to);
  EXPECT_EQ(to.t, 1.5);
  EXPECT_EQ(to.x, (std::vector<double>{2.25, -0.5}));
  EXPECT_EQ(to.v, (std::vector<double>{-2.0, 2.0}));
  EXPECT_EQ(to.z, from.z);
}

// --- contacts ---

constexpr double pull = 9.81;  // [m/s^2]

Model ballOnGround(int dimension, double k, double d, double height, double v = 0.0) {
  Model model;
  model.dimension = dimension;
  const Vec3 up = dimension == 1 ? Vec3(Vec3::UnitX()) : Vec3(Vec3::UnitZ());
  model.gravity = -pull * up;
  ModelNode ball = {.x = height * up, .v = v * up, .m = 2.0};
  if (dimension > 1) ball.v.x() = 0.75;
  model.nodes = {ball};
  Obstacle ground;
  ground.normal = up;
  ground.material.k = k;
  ground.material.d = d;
  model.obstacles = {ground};
  return model;
}

RunResult runOf(const Model& model, double duration, double tolerance = 1e-6) {
  const auto system = build(model);
  const auto method = makeMethod("dop853");
  RunOptions options;
  options.duration = duration;
  options.tolerance.relative = tolerance;
  return simulate(*system, *method, system->initialState(), options);
}

bool isAllInClosedForm(const Model& model, double duration = 1.0) {
  const RunResult run = runOf(model, duration);
  EXPECT_FALSE(run.failed()) << run.trajectory.stop.message;
  return run.work.inClosedForm == run.work.steps;
}

class ContactInClosedForm : public ::testing::TestWithParam<int> {};

TEST_P(ContactInClosedForm, GivesTheBallItsSpeedBackWithoutAnyForce) {
  const RunResult run = runOf(ballOnGround(GetParam(), 1e4, 0.0, 0.5), 10.0);
  ASSERT_FALSE(run.failed());
  EXPECT_EQ(run.work.inClosedForm, run.work.steps);
  EXPECT_LE(run.work.forceEvaluations, 3) << "the start and the choice of a first step";
  const double impact = std::sqrt(pull), w = std::sqrt(1e4 / 2.0);
  const double contact = 2.0 / w * (std::numbers::pi / 2.0 + std::atan(pull / (impact * w)));
  const double period = 2.0 * impact / pull + contact;
  for (std::size_t i = 0; i < run.events.size(); ++i) {
    const double begin = impact / pull + static_cast<double>(i / 2) * period;
    EXPECT_NEAR(run.events[i].t, i % 2 == 0 ? begin : begin + contact, 4e-14) << i;
  }
  EXPECT_EQ(run.work.events, static_cast<long long>(run.events.size()));
}

/// With damping a contact lets go where N = k depth - d w = 0, below the surface.
TEST_P(ContactInClosedForm, LetsGoOfADampedBallWhereTheGroundWouldPull) {
  for (const double d : {1.0, 60.0, 140.0, 250.0}) {
    const RunResult run = runOf(ballOnGround(GetParam(), 1e4, d, 0.5), 0.6);
    ASSERT_FALSE(run.failed());
    EXPECT_EQ(run.work.inClosedForm, run.work.steps) << d;
    ASSERT_GE(run.events.size(), 2U);
    const Lane lane = {-pull, 1e4 / 2.0, d / 2.0, 0.0, -std::sqrt(pull)};
    const Exact end = exactly(lane, run.events[1].t - run.events[0].t);
    EXPECT_NEAR(static_cast<double>(-1e4 * end.x - d * end.v), 0.0, 1e-9 * 1e4 * 0.05) << d;
    EXPECT_LE(static_cast<double>(end.x), 0.0);
  }
}

TEST_P(ContactInClosedForm, StopsABallFarBeyondCriticalDamping) {
  for (const double d : {400.0, 1000.0}) {  // critical: 283, where N still would pull after 2 / w
    const RunResult run = runOf(ballOnGround(GetParam(), 1e4, d, 0.5), 0.6);
    ASSERT_FALSE(run.failed());
    EXPECT_EQ(run.work.inClosedForm, run.work.steps) << d;
    ASSERT_EQ(run.events.size(), 1U) << d;
    const Exact end = exactly({-pull, 1e4 / 2.0, d / 2.0, 0.0, -std::sqrt(pull)}, 0.6 - run.events[0].t);
    EXPECT_NEAR(run.last.x[GetParam() == 1 ? 0 : static_cast<std::size_t>(GetParam()) - 1], static_cast<double>(end.x),
                1e-14);
  }
}

TEST_P(ContactInClosedForm, HoldsABallThatSwingsOnTheGround) {
  // At rest m g / k deep; amplitudes below and above that, which is where it leaves the ground in each swing.
  const double k = 500.0, deep = 2.0 * pull / k, w = std::sqrt(k / 2.0);
  EXPECT_EQ(runOf(ballOnGround(GetParam(), k, 0.0, -deep, 0.999 * deep * w), 20.0).work.events, 0);
  const RunResult leaves = runOf(ballOnGround(GetParam(), k, 0.0, -deep, 1.001 * deep * w), 20.0);
  // 1.001 cos phi = 1 at the surface: it is above it for little; the period is nearly that of the swing.
  const double periods = 20.0 * w / (2.0 * std::numbers::pi);
  EXPECT_NEAR(static_cast<double>(leaves.work.events), 2.0 * periods, 2.0);
  EXPECT_EQ(leaves.work.inClosedForm, leaves.work.steps);
}

INSTANTIATE_TEST_SUITE_P(Dimension, ContactInClosedForm, ::testing::Values(1, 2, 3),
                         [](const auto& dimension) { return std::to_string(dimension.param) + "D"; });

TEST(ContactInClosedForm, IsThatOfTheMethodWhereItIsNone) {
  Model alone = ballOnGround(3, 1e4, 20.0, 0.5);
  Model beside = alone;  // a pair that swings far away: the lanes are coupled, and the method takes all of it
  beside.nodes.push_back({.x = {50, 0, 50}, .m = 1.0});
  beside.nodes.push_back({.x = {51, 0, 50}, .v = {0, 0, 1}, .m = 1.0});
  beside.springs = {{.a = 1, .b = 2, .k = 50.0, .L0 = 1.0}};
  const RunResult closed = runOf(alone, 1.2), followed = runOf(beside, 1.2, 1e-11);
  EXPECT_EQ(followed.work.inClosedForm, 0);
  ASSERT_EQ(closed.events.size(), followed.events.size());
  for (std::size_t i = 0; i < closed.events.size(); ++i) {
    EXPECT_EQ(closed.events[i].what, followed.events[i].what);
    EXPECT_NEAR(closed.events[i].t, followed.events[i].t, 1e-9);
  }
}

TEST(ContactInClosedForm, IsTakenByTheMethodWhereLanesAreNotAlone) {
  const auto with = [](const std::function<void(Obstacle&)>& change) {
    Model model = ballOnGround(3, 1e4, 10.0, 0.1);
    change(model.obstacles.front());
    return model;
  };
  EXPECT_TRUE(isAllInClosedForm(with([](Obstacle&) {})));
  EXPECT_FALSE(isAllInClosedForm(with([](Obstacle& o) { o.normal = Vec3(0.6, 0.0, 0.8); })));
  EXPECT_FALSE(isAllInClosedForm(with([](Obstacle& o) { o.material.mu = 0.3; })));
  EXPECT_FALSE(isAllInClosedForm(with([](Obstacle& o) { o.velocity = {0, 0, 0.1}; })));
  EXPECT_FALSE(isAllInClosedForm(with([](Obstacle& o) { o.material.d = 5000.0; })));
  EXPECT_FALSE(isAllInClosedForm(with([](Obstacle& o) {
    o.kind = Obstacle::Kind::Sphere;
    o.centre = {0, 0, -1};
  })));
  Model falling = ballOnGround(3, 1e4, 10.0, 0.1);
  falling.nodes[0].drag = 0.1;
  EXPECT_FALSE(isAllInClosedForm(falling));
}

TEST(ContactInClosedForm, OfACornerIsInBothLanes) {
  Model model = ballOnGround(2, 1e4, 0.0, 0.5);
  Obstacle wall = model.obstacles.front();
  wall.name = "wall";
  wall.normal = {-1, 0, 0};
  wall.centre = {0.24, 0, 0};  // reached at 0.32 s, in the middle of the touch of the ground that begins at 0.319 s
  model.obstacles.push_back(wall);
  const RunResult run = runOf(model, 0.6);
  ASSERT_FALSE(run.failed());
  EXPECT_EQ(run.work.inClosedForm, run.work.steps);
  ASSERT_EQ(run.events.size(), 4U);
  EXPECT_NEAR(run.events[1].t, 0.32, 1e-14);
  EXPECT_EQ(run.events[1].what, "node 0 touches 'wall'");
  EXPECT_EQ(run.events[2].what, "node 0 leaves 'wall'");
  EXPECT_NEAR(run.events[2].t - run.events[1].t, std::numbers::pi / std::sqrt(1e4 / 2.0), 1e-13);
}

}  // namespace
}  // namespace muelle::engine
