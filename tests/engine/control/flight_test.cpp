#include "engine/control/simulate.h"
#include "engine/integrators/catalogue.h"
#include "engine/model/model_system.h"

#include <gtest/gtest.h>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace muelle::engine {
namespace {

constexpr double fall = 9.81;  // [m/s^2]

ModelNode ball(double height, double v = 0.0) {
  ModelNode node;
  node.x = {0, 0, height};
  node.v = {0, 0, v};
  node.m = 2.0;
  return node;
}

Obstacle plane(const std::string& name, double height, double up) {
  Obstacle plane;
  plane.name = name;
  plane.centre = {0, 0, height};
  plane.normal = {0, 0, up};
  plane.material.k = 1e5;
  return plane;
}

Model balls(std::vector<ModelNode> nodes) {
  Model model;
  model.gravity = {0, 0, -fall};
  model.nodes = std::move(nodes);
  model.obstacles = {plane("floor", 0.0, 1.0)};
  return model;
}

RunOptions within(double tolerance, double duration) {
  RunOptions options;
  options.tolerance.relative = tolerance;
  options.duration = duration;
  return options;
}

/// Every method that controls its error and can run these scenes.
class Flight : public ::testing::TestWithParam<std::string> {
 protected:
  RunResult run(const Model& model, const RunOptions& options) {
    system_ = build(model);
    method_ = makeMethod(GetParam());
    return simulate(*system_, *method_, system_->initialState(), options);
  }
  double heightAt(const State& state, int node = 0) const { return system_->position(state, node)[2]; }

 private:
  std::unique_ptr<ModelSystem> system_;
  std::unique_ptr<Integrator> method_;
};

TEST_P(Flight, InTheAirCostsNoForceAndIsExact) {
  RunOptions options = within(1e-3, 2.0);
  options.outputInterval = 0.25;
  const RunResult result = run(balls({ball(100.0, 3.0)}), options);
  ASSERT_FALSE(result.failed());
  const Trajectory& seen = result.trajectory;
  ASSERT_EQ(seen.t.size(), 9U);
  for (std::size_t i = 0; i < seen.t.size(); ++i) {
    const double t = seen.t[i];
    EXPECT_NEAR(seen.x[i][2], 100.0 + 3.0 * t - 0.5 * fall * t * t, 1e-13 * 100.0);
  }
  EXPECT_LE(result.work.forceEvaluations, 3) << "the start and the choice of a first step";
  EXPECT_EQ(result.work.steps, 1) << "outputs are looked at inside the flight";
  EXPECT_EQ(result.work.inClosedForm, 1);
}

TEST_P(Flight, EndsAtTheFirstOfSeveralObstacles) {
  // Up against the ceiling and down to the floor, in one flight that would end far below both.
  Model model = balls({ball(1.0, 12.0)});
  model.obstacles.push_back(plane("ceiling", 3.0, -1.0));
  const RunResult result = run(model, within(1e-6, 1.0));
  ASSERT_FALSE(result.failed());
  ASSERT_GE(result.events.size(), 3U);
  EXPECT_EQ(result.events[0].what, "node 0 touches 'ceiling'");
  EXPECT_NEAR(result.events[0].t, (12.0 - std::sqrt(144.0 - 4.0 * fall)) / fall, 1e-13);
  EXPECT_EQ(result.events[1].what, "node 0 leaves 'ceiling'");
  EXPECT_EQ(result.events[2].what, "node 0 touches 'floor'");
}

TEST_P(Flight, SeesATouchThatIsOverLongBeforeItsEnd) {
  // Just into the ceiling at the top of a flight of 4 s, for 9 ms of it.
  Model model = balls({ball(80.0, 0.5 * fall)});
  const double top = 80.0 + 0.125 * fall, over = 1e-4;
  model.obstacles.push_back(plane("ceiling", top - over, -1.0));
  const RunResult result = run(model, within(1e-6, 4.0));
  ASSERT_FALSE(result.failed());
  ASSERT_GE(result.events.size(), 2U);
  EXPECT_NEAR(result.events[0].t, 0.5 - std::sqrt(2.0 * over / fall), 1e-10);
}

TEST_P(Flight, KeepsTheEnergyOfTheClosedFormOverBounces) {
  const RunResult result = run(balls({ball(1.0)}), within(1e-9, 10.0));
  ASSERT_FALSE(result.failed());
  const double impact = std::sqrt(2.0 * fall), w = std::sqrt(1e5 / 2.0);
  const double contact = 2.0 / w * (std::numbers::pi / 2.0 + std::atan(fall / (impact * w)));
  const double period = 2.0 * impact / fall + contact;
  ASSERT_EQ(result.work.events, 22);
  for (std::size_t i = 0; i < result.events.size(); i += 2) {
    const double touch = impact / fall + static_cast<double>(i / 2) * period;
    EXPECT_NEAR(result.events[i].t, touch, 1e-7) << "bounce " << i / 2;
  }
}

TEST_P(Flight, OfOneBallWaitsForTheOthers) {
  // While any of them touches the floor, the method makes the steps of all: the same motion as each alone.
  const RunOptions options = within(1e-10, 3.0);
  const RunResult together = run(balls({ball(1.0), ball(0.37)}), options);
  const State last = together.last;
  const double high = heightAt(last, 0), low = heightAt(last, 1);
  const RunResult first = run(balls({ball(1.0)}), options);
  EXPECT_NEAR(heightAt(first.last), high, 1e-7);
  const RunResult second = run(balls({ball(0.37)}), options);
  EXPECT_NEAR(heightAt(second.last), low, 1e-7);
}

TEST_P(Flight, TellsManyEventsInTheirOrder) {
  // Balls between floor and ceiling and beside a ball that is fixed, all set off at random: each moves as if alone.
  std::mt19937 dice(7);
  const auto between = [&dice](double low, double high) {
    return low + (high - low) * static_cast<double>(dice()) / static_cast<double>(std::mt19937::max());
  };
  for (int scene = 0; scene < 12; ++scene) {
    Model model = balls({});
    model.obstacles.push_back(plane("ceiling", between(1.2, 2.0), -1.0));
    Obstacle sphere = plane("sphere", 0.3, 1.0);
    sphere.kind = Obstacle::Kind::Sphere;
    sphere.centre[0] = 0.1;
    sphere.radius = 0.25;
    model.obstacles.push_back(sphere);
    for (int i = 0; i < 5; ++i) model.nodes.push_back(ball(between(0.6, 1.1), between(-4.0, 6.0)));
    const RunOptions options = within(1e-8, 1.5);
    const RunResult together = run(model, options);
    ASSERT_FALSE(together.failed());
    EXPECT_GE(together.work.events, 10);
    std::vector<double> heights;
    for (int i = 0; i < 5; ++i) heights.push_back(heightAt(together.last, i));
    for (int i = 0; i < 5; ++i) {
      Model alone = model;
      alone.nodes = {model.nodes[static_cast<std::size_t>(i)]};
      const RunResult result = run(alone, options);
      // A bounce off a ball that is not hit in its middle makes errors ten times as large, and there are several.
      EXPECT_NEAR(heightAt(result.last), heights[static_cast<std::size_t>(i)], 2e-4) << "scene " << scene;
    }
  }
}

TEST_P(Flight, KeepsToTheLargestStep) {
  RunOptions options = within(1e-3, 2.0);
  options.largestStep = 0.125;
  const RunResult result = run(balls({ball(100.0)}), options);
  EXPECT_EQ(result.work.steps, 16);
}

TEST_P(Flight, IsNoneWhereTheForceVaries) {
  // Drag is exact in Nystroem methods only; what matters is that the closed form of the vacuum is not taken for it.
  Model model = balls({ball(100.0)});
  model.nodes[0].drag = 1.0;
  const RunResult result = run(model, within(1e-9, 2.0));
  ASSERT_FALSE(result.failed());
  const double rate = 1.0 / 2.0, sunk = fall / rate * (2.0 - (1.0 - std::exp(-rate * 2.0)) / rate);
  EXPECT_NEAR(heightAt(result.last), 100.0 - sunk, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Methods, Flight,
                         ::testing::Values("dormand_prince_5", "dop853", "rkn64", "nystrom8", "nystrom12", "esdirk4"),
                         [](const auto& method) { return method.param; });

TEST(FreeFlight, IsNotTakenFromAMethodOfFixedSteps) {
  // What explicit Euler makes of a parabola is for the student to see: too high by g h t / 2.
  const auto system = build(balls({ball(100.0)}));
  const auto method = makeMethod("explicit_euler");
  RunOptions options;
  options.h = 0.01;
  options.duration = 1.0;
  const RunResult result = simulate(*system, *method, system->initialState(), options);
  EXPECT_NEAR(system->position(result.last, 0)[2], 100.0 - 0.5 * fall + 0.5 * fall * 0.01, 1e-10);
}

TEST(FreeFlight, KeepsTheLowPartsOfCompensatedSums) {
  // Ten thousand flights of 1e-4 s, as largestStep has it: their sum is exact but for its own rounding.
  const auto system = build(balls({ball(1000.0, 1.0 / 3.0)}));
  const auto method = makeMethod("dop853");
  RunOptions options = within(1e-6, 1.0);
  options.largestStep = 1e-4;
  options.compensated = true;
  const RunResult result = simulate(*system, *method, system->initialState(), options);
  EXPECT_NEAR(system->position(result.last, 0)[2], 1000.0 + 1.0 / 3.0 - 0.5 * fall, 2.5e-13);
}

}  // namespace
}  // namespace muelle::engine
