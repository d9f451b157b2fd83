#include "engine/control/simulate.h"
#include "test_methods.h"
#include "test_systems.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace muelle::engine {
namespace {

using testing::PenaltyBalls;
using testing::PulsedMass;

constexpr double g = 9.81;

State ballsAt(std::vector<double> heights) {
  const std::size_t n = heights.size();
  return {0.0, std::move(heights), std::vector<double>(n, 0.0), {}};
}

RunOptions fixedSteps(double h, double duration) {
  RunOptions options;
  options.h = h;
  options.duration = duration;
  options.checkStability = options.checkNumericalDamping = false;
  return options;
}

/// Hard case H17 in closed form: the state of the undamped ball at time t, and the length of a contact.
struct Bounce {
  double k, height;
  double impact = std::sqrt(2.0 * g * height), w = std::sqrt(k);
  double contact = 2.0 / w * (std::numbers::pi / 2.0 + std::atan(g / (impact * w)));
};

TEST(Events, AFallingBallTouchesAtTheTimeOfTheClosedForm) {
  const PenaltyBalls balls(1, 1e5, 0.0, g);
  const Bounce bounce{1e5, 1.0};
  const double touch = bounce.impact / g;
  for (const double h : {1.0 / 60.0, 1e-3}) {
    const auto method = testing::classicalRungeKutta();
    const RunResult run = simulate(balls, *method, ballsAt({1.0}), fixedSteps(h, 0.47));
    ASSERT_FALSE(run.failed()) << run.trajectory.stop.message;
    ASSERT_FALSE(run.events.empty());
    EXPECT_NEAR(run.events[0].t, touch, 1e-12);
    EXPECT_EQ(run.events[0].what, "ball 0 touches or leaves the plane");
  }
}

TEST(Events, ABounceWithinOneLongStepIsSeen) {
  // A fall into a soft plane and out again between two ends of a step: only the inside of the step shows it.
  const PenaltyBalls balls(1, 1e5, 0.0, 0.0);
  const auto method = testing::classicalRungeKutta();
  RunOptions options = fixedSteps(1e-3, 0.5);
  State start = ballsAt({0.1});
  start.v[0] = -1.0;
  const RunResult run = simulate(balls, *method, start, options);
  ASSERT_EQ(run.work.events, 2);
  EXPECT_NEAR(run.events[0].t, 0.1, 1e-12);
  EXPECT_NEAR(run.events[1].t - run.events[0].t, std::numbers::pi / std::sqrt(1e5), 2e-6) << "H17, zero g";
}

TEST(Events, ATouchThatTheStepEndsDoNotShowIsFound) {
  // Thrown up from 1e-4 above the plane so that it dips 1e-4 below between two grid points: x = x0 - v t + 5 t^2.
  const PenaltyBalls balls(1, 100.0, 0.0, -10.0);
  State start = ballsAt({0.05});
  start.v[0] = -1.2;  // lowest at t = 0.12: 0.05 - 0.072 < 0; back above 0 before t = 0.2
  const auto method = testing::classicalRungeKutta();
  const RunResult run = simulate(balls, *method, start, fixedSteps(0.25, 0.25));
  ASSERT_GE(run.work.events, 1);
  EXPECT_NEAR(run.events[0].t, 0.12 - std::sqrt(0.0144 - 0.01), 1e-12);
}

TEST(Events, KeepTheOrderOfTheMethodThroughBounces) {
  const PenaltyBalls balls(1, 1e4, 0.0, g);
  const Bounce bounce{1e4, 1.0};
  const double fall = bounce.impact / g;
  const double t = fall + bounce.contact + 0.3;  // on the way up after one bounce
  const double exact = bounce.impact * 0.3 - 0.5 * g * 0.09;
  std::vector<double> errors;
  for (const double h : {4e-3, 2e-3, 1e-3, 5e-4}) {
    const auto method = testing::classicalRungeKutta();
    const RunResult run = simulate(balls, *method, ballsAt({1.0}), fixedSteps(h, t));
    ASSERT_EQ(run.work.events, 2);
    errors.push_back(std::abs(run.last.x[0] - exact));
  }
  const double order = std::log2(errors[0] / errors[3]) / 3.0;
  // On an oscillator the phase error of RK4 is of order 4 and its loss of amplitude of order 5; both count here.
  EXPECT_GT(order, 3.9) << errors[0] << " " << errors[1] << " " << errors[2] << " " << errors[3];
  RunOptions options = fixedSteps(5e-4, t);
  options.locateEvents = false;
  const auto method = testing::classicalRungeKutta();
  const RunResult live = simulate(balls, *method, ballsAt({1.0}), options);
  EXPECT_GT(std::abs(live.last.x[0] - exact), 100.0 * errors[3]) << "without events the order is lost";
}

TEST(Events, ElevenBouncesInTenSecondsByAdaptiveSteps) {
  const PenaltyBalls balls(1, 1e5, 0.0, g);
  const auto method = testing::bogackiShampine();
  RunOptions options;
  options.duration = 10.0;
  options.tolerance = {.relative = 1e-9};
  options.outputInterval = 10.0;
  const RunResult run = simulate(balls, *method, ballsAt({1.0}), options);
  ASSERT_FALSE(run.failed()) << run.trajectory.stop.message;
  EXPECT_EQ(run.work.events, 22);
  EXPECT_NEAR(run.last.x[0], 0.990808844434861728444, 1e-5);
  EXPECT_NEAR(run.last.v[0], 0.424653355324095947426, 2e-5);
}

TEST(Events, BallsOfDifferentHeightsTouchInOrderAndEqualOnesTogether) {
  const PenaltyBalls balls(4, 1e4, 0.0, g);
  const auto method = testing::classicalRungeKutta();
  const RunResult run = simulate(balls, *method, ballsAt({1.0, 0.5, 1.0, 0.999999}), fixedSteps(0.01, 0.46));
  ASSERT_FALSE(run.failed());
  std::vector<double> touches;
  for (const double height : {0.5, 0.999999, 1.0, 1.0}) touches.push_back(std::sqrt(2.0 * height / g));
  std::vector<double> seen;
  for (const RunEvent& event : run.events) seen.push_back(event.t);
  std::erase_if(seen, [](double t) { return t > 0.325 && t < 0.45; });  // the lowest ball leaves
  ASSERT_GE(seen.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(seen[i], touches[i], 1e-12);
}

TEST(Events, ADampedContactSticksOnTouch) {
  // Hard case H21 (overdamped, zeta = 50): with live modes any explicit step of 1e-4 s is far off.
  const PenaltyBalls balls(1, 1e4, 1e4, g);
  const auto method = testing::classicalRungeKutta();
  RunOptions options = fixedSteps(1e-4, 2.0);
  options.outputInterval = 1.0;
  const RunResult run = simulate(balls, *method, ballsAt({1.0}), options);
  ASSERT_FALSE(run.failed()) << run.trajectory.stop.message;
  EXPECT_EQ(run.work.events, 1);
  EXPECT_NEAR(run.events[0].t, 0.451523640985730904451, 1e-12);
  EXPECT_NEAR(run.trajectory.x[1][0], -0.000670107304382872813147, 1e-6);
  EXPECT_NEAR(run.last.x[0], -0.000866640407691128459074, 1e-6);
}

TEST(Events, AStartOnTheSurfaceTakesTheModeOfItsMotion) {
  const PenaltyBalls balls(2, 1e4, 0.0, 0.0);
  State start = ballsAt({0.0, 0.0});
  start.v = {-1.0, 1.0};
  const auto method = testing::classicalRungeKutta();
  const RunResult run = simulate(balls, *method, start, fixedSteps(1e-4, 0.1));
  EXPECT_EQ(run.work.events, 1) << "one leaves, and nothing touches";
  EXPECT_NEAR(run.last.x[0], 0.1 - std::numbers::pi / 100.0, 1e-8);
  EXPECT_NEAR(run.last.x[1], 0.1, 1e-14);
}

TEST(DeclaredTimes, APulseIsIntegratedExactly) {
  // Hard case H22: 1000 N for 1 ms. Velocity 1, x(2) = 0.5e-3 + 0.999.
  const PulsedMass mass([](double, int segment) { return segment == 1 ? 1000.0 : 0.0; }, {1.0, 1.001});
  for (const bool adaptive : {false, true}) {
    const auto method = adaptive ? testing::bogackiShampine() : testing::classicalRungeKutta();
    RunOptions options = fixedSteps(adaptive ? 0.0 : 1.0 / 60.0, 2.0);
    const RunResult run = simulate(mass, *method, ballsAt({0.0}), options);
    ASSERT_FALSE(run.failed()) << run.trajectory.stop.message;
    EXPECT_NEAR(run.last.v[0], 1.0, 1e-12);
    EXPECT_NEAR(run.last.x[0], 0.9995, 1e-12);
    ASSERT_EQ(run.work.events, 2);
    EXPECT_EQ(run.events[0].t, 1.0);
    EXPECT_EQ(run.events[1].t, 1.001);
  }
}

TEST(DeclaredTimes, AnUnannouncedForceIsRefusedWithoutALargestStep) {
  const auto pulse = [](double t, int) { return t >= 1.0 && t < 1.001 ? 1000.0 : 0.0; };
  const PulsedMass mass(pulse, {}, false);
  const auto method = testing::bogackiShampine();
  RunOptions options = fixedSteps(0.0, 2.0);
  EXPECT_THROW(simulate(mass, *method, ballsAt({0.0}), options), std::invalid_argument);
  options.largestStep = 5e-4;
  const RunResult run = simulate(mass, *method, ballsAt({0.0}), options);
  // An acceleration a that sets in at the share s of a step makes v wrong by h a |B - (1 - s)|, B the sum of the
  // weights of the stages behind it; the estimate, which the tolerance of 1e-6 bounds, is h a times the sum of these
  // less the embedded weights. Where s is 3/4 that is 7/36 and 1/72, 14 times less; elsewhere it is nearer. Two jumps,
  // then 1 s.
  EXPECT_NEAR(run.last.x[0], 0.9995, 2 * 14e-6) << "the error estimate sees the jump and closes in on it";
}

TEST(DeclaredTimes, WithoutEventsARunOfFixedStepsSaysThatItStepsOverThem) {
  const PulsedMass mass([](double, int segment) { return segment == 1 ? 1000.0 : 0.0; }, {1.0, 1.001});
  const auto method = testing::classicalRungeKutta();
  RunOptions options = fixedSteps(0.03, 2.0);
  options.locateEvents = false;
  const RunResult run = simulate(mass, *method, ballsAt({0.0}), options);
  EXPECT_EQ(run.last.x[0], 0.0) << "the expected failure of H22: missed whole";
  ASSERT_FALSE(run.warnings.empty());
  EXPECT_NE(run.warnings[0].find("declared times"), std::string::npos);
}

TEST(DeclaredTimes, AreKeptByAdaptiveMethodsWithoutEvents) {
  const PulsedMass mass([](double, int segment) { return segment == 1 ? 1000.0 : 0.0; }, {1.0, 1.001});
  const auto method = testing::bogackiShampine();
  RunOptions options = fixedSteps(0.0, 2.0);
  options.locateEvents = false;
  const RunResult run = simulate(mass, *method, ballsAt({0.0}), options);
  // A thousand newtons for a millisecond leave 1 m/s, half a millimetre behind.
  EXPECT_NEAR(run.last.x[0], 0.9995, 1e-4) << "at rest no error estimate tells of what comes";
  EXPECT_TRUE(run.warnings.empty());
}

TEST(SweptBound, NothingPassesThroughAThinPlate) {
  // Hard case H19 turned: 100 m/s at a plate of 1 cm, in steps of 1.67 m. Exact: rebounds with +100 m/s.
  PenaltyBalls balls(1, 4e8, 0.0, 0.0);
  balls.thickness = 0.01;
  State start = ballsAt({1.0});
  start.v[0] = -100.0;
  for (const bool locate : {true, false}) {
    const auto method = testing::classicalRungeKutta();
    RunOptions options = fixedSteps(1.0 / 60.0, 0.1);
    options.locateEvents = locate;
    const RunResult run = simulate(balls, *method, start, options);
    ASSERT_FALSE(run.failed()) << run.trajectory.stop.message;
    EXPECT_GT(run.last.x[0], 0.0);
    EXPECT_GT(run.subdividedSteps, 0);
    const auto told = [](const std::string& warning) { return warning.find("passes through") != std::string::npos; };
    EXPECT_EQ(std::count_if(run.warnings.begin(), run.warnings.end(), told), 1) << "said once";
    EXPECT_NEAR(run.last.x[0], 8.98429203673205103381, locate ? 1e-3 : 10.0);
  }
}

/// A mode that flips at every crossing and drives the state back: infinitely many events in any time.
class Chattering : public PenaltyBalls {
 public:
  Chattering() : PenaltyBalls(1, 1.0, 0.0, 0.0) {}
  void force(double, In x, In, In z, Out f) const override {
    f[0] = z[0] == 0.0 ? (x[0] > 0.0 ? -1.0 : 1.0) : (z[0] == 1.0 ? -1.0 : 1.0);
  }
  void guards(double, In x, In v, In, Out value) const override { value[0] = x[0] + v[0]; }
  bool commit(State& state, bool frozen) const override {
    if (!frozen) state.z[0] = 0.0;
    if (frozen && state.z[0] == 0.0) state.z[0] = state.x[0] + state.v[0] > 0.0 ? 1.0 : 2.0;
    return false;
  }
  void cross(int, State& state) const override { state.z[0] = 3.0 - state.z[0]; }
};

TEST(Events, ChatterEndsInAStepWithLiveModesAndAWarning) {
  const Chattering system;
  const auto method = testing::classicalRungeKutta();
  RunOptions options = fixedSteps(0.01, 3.0);
  options.mostSteps = 100'000;
  const RunResult run = simulate(system, *method, ballsAt({1.0}), options);
  EXPECT_FALSE(run.failed()) << run.trajectory.stop.message;
  EXPECT_EQ(run.last.t, 3.0);
  ASSERT_FALSE(run.warnings.empty());
  EXPECT_NE(run.warnings.back().find("without locating events"), std::string::npos);
}

}  // namespace
}  // namespace muelle::engine
