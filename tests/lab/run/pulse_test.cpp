/// \file
/// What acts for a short time only: no adaptive method steps over it, at any tolerance; a fixed step that would says
/// so, and one whose steps end there keeps its order. A node of 1 kg at rest on a spring of 100 N/m is struck
/// after 1.234 s for 20 ms in each way that scene files have.

#include "lab/run/error_estimate.h"
#include "lab/run/tolerance_sweep.h"
#include "references.h"
#include "support/scene_text.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <limits>

namespace muelle::lab {

namespace pulses {

using namespace engine;
namespace {

const std::string held = "[[node]]\nx = 0.0\npinned = true\n", moved = "[[node]]\nx = 0.0\n";
const std::string struck =
    "[[node]]\nx = 1.0\nm = 1.0\n[[spring]]\nnodes = [0, 1]\nk = 100.0\nL0 = 1.0\nsigned = true\n";
const std::string force = held + struck + "[[force]]\nnodes = [1]\nF = 10.0\n";
const std::string motion = moved + struck + "[[motion]]\nnodes = [0]\n";
const std::string when = "during = [1.234, 1.254]\n";

/// The largest distance from the start [m].
double amplitude(const Trajectory& path) {
  double largest = 0.0;
  for (const std::vector<double>& x : path.x) largest = std::max(largest, std::abs(x[0] - path.x[0][0]));
  return largest;
}

struct Pulse {
  const char* name;
  std::string text;
  bool hasPeriod = false;
};

std::vector<Pulse> pulses() {
  return {{"jump", force + when},
          {"half sine", force + when + "frequency = 25.0\n", true},
          {"burst of three periods", force + "during = [1.234, 1.294]\nfrequency = 50.0\n", true},
          {"stroke of the anchor", motion + "displacement = 0.1\n" + when},
          {"anchor that goes and stops", motion + "velocity = 5.0\n" + when},
          {"anchor that shakes for 1.25 periods",
           motion + "amplitude = 0.1\nfrequency = 50.0\nduring = [1.234, 1.259]\n", true},
          {"obstacle that pushes and stops",
           moved + "m = 1.0\n" + struck +
               "[[obstacle]]\nshape = 'plane'\nname = 'hammer'\npoint = -2.448\nnormal = 1.0\nk = 1e3\nvelocity = 2.0\n"
               "stop_time = 1.254\n"}};
}

Scene sceneOf(const Pulse& pulse) {
  Scene scene = sceneFrom(head + pulse.text + engine::run);
  scene.duration = 2.0;
  return scene;
}

TEST(Pulses, AreSteppedOverByNoAdaptiveMethodAtAnyTolerance) {
  for (const Pulse& pulse : pulses()) {
    const Scene scene = sceneOf(pulse);
    const auto system = build(scene.model);
    const Trajectory exact = runAtTolerance(*system, "dop853", 1e-13, scene.duration);
    std::vector<double> times(exact.t.begin() + 1, exact.t.end());
    // A second source: one that stepped over the pulse would be off by 1. (Fehlberg's method stumbles over jumps.)
    EXPECT_LT(errorOver(*system, secondRun(scene, *system, system->initialState(), times), exact), 1e-3) << pulse.name;
    for (const char* id : {"dormand_prince_5", "dop853", "nystrom8", "nystrom12", "rkc2"}) {
      for (const double tolerance : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10}) {
        const bool second = id == std::string("rkc2");
        if (second && tolerance < 1e-6) continue;  // too many steps for a test
        // Ten steps or so of at most the tolerance; of the second order, errors go as its square root.
        const double most = second ? 4.0 * std::sqrt(tolerance) : 20.0 * tolerance;
        EXPECT_LT(errorOver(*system, runAtTolerance(*system, id, tolerance, scene.duration), exact), most)
            << pulse.name << ", " << id << " at " << tolerance;
      }
    }
  }
}

/// With events off the stages at a pulse's ends may see its force, which costs the tolerance but misses nothing.
TEST(Pulses, AreNotSteppedOverByAdaptiveMethodsWhereEventsAreOff) {
  for (const Pulse& pulse : pulses()) {
    Scene scene = sceneOf(pulse);
    const auto system = build(scene.model);
    const Trajectory exact = runAtTolerance(*system, "dop853", 1e-13, scene.duration);
    scene.locateEvents = false;
    scene.largestStep = std::numeric_limits<double>::infinity();
    for (const char* id : {"dormand_prince_5", "dop853", "nystrom12", "tr_bdf2"}) {
      for (const double tolerance : {1e-2, 1e-6}) {
        scene.method = id;
        scene.tolerance = tolerance;
        const SceneRun run = runScene(scene);
        ASSERT_FALSE(run.result.failed()) << pulse.name << ", " << id;
        // Stepped over, the error is 1; of the second order, errors go as the tolerance's power 2/3.
        const double most = id == std::string("tr_bdf2") ? 0.3 : 20.0 * tolerance;
        const double off = std::abs(run.result.trajectory.x.back()[0] - exact.x.back()[0]);
        EXPECT_LT(off, most * amplitude(exact)) << pulse.name << ", " << id << " at " << tolerance;
        EXPECT_TRUE(run.result.warnings.empty()) << run.result.warnings[0];
      }
    }
  }
}

TEST(Pulses, WhoseEndsAreStepsCostNoOrder) {
  for (const Pulse& pulse : pulses()) {
    Scene scene = sceneOf(pulse);
    scene.method = "runge_kutta_4";
    const auto system = build(scene.model);
    const auto error = [&](double h) {
      scene.step = h;
      const Trajectory path = runScene(scene).result.trajectory;
      const std::vector<double> times(path.t.begin() + 1, path.t.end());
      return errorOver(*system, path, finestRun(scene, *system, system->initialState(), times));
    };
    EXPECT_NEAR(std::log2(error(1e-3) / error(5e-4)), 4.0, 0.4) << pulse.name;
  }
}

TEST(Pulses, ThatAFixedStepDoesNotResolveAreWarnedOfAndLeaveNoEstimate) {
  for (const Pulse& pulse : pulses()) {
    if (pulse.text.find("obstacle") != std::string::npos) continue;  // its bounce takes 0.1 s
    Scene scene = sceneOf(pulse);
    scene.duration = 20.0;  // so that a pulse is short beside it
    scene.step = 0.03;
    scene.method = "velocity_verlet";
    scene.locateEvents = pulse.hasPeriod;
    const SceneRun run = runScene(scene);
    const std::string expected = pulse.hasPeriod ? "does not resolve it" : "events are not located";
    bool warned = false;
    for (const std::string& warning : run.result.warnings) warned |= warning.find(expected) != std::string::npos;
    EXPECT_TRUE(warned) << pulse.name;
    EXPECT_NE(estimateError(scene, run).failure, "") << pulse.name;
  }
}

}  // namespace
}  // namespace pulses
}  // namespace muelle::lab
