/// \file
/// What a tolerance is worth: a tighter one never costs accuracy. (The figure tolerance_against_error shows it.)

#include "engine/integrators/catalogue.h"
#include "engine/model/model_system.h"
#include "lab/hard_cases/models.h"
#include "lab/run/tolerance_sweep.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace muelle::lab {

using namespace engine;
namespace {

struct Problem {
  const char* name;
  Model model;
  double duration;
};

std::vector<Problem> smoothProblems() {
  return {{"oscillator, 100 periods", hard_cases::oscillator(100.0), 20.0 * 3.14159265358979},
          {"elastic pendulum", hard_cases::regularPendulum(), 10.0},
          {"conical pendulum", hard_cases::conicalPendulum(), 10.0},
          {"triangle", hard_cases::triangle(), 5.0},
          {"hanging chain", hard_cases::hangingChain(), 1.0},
          {"damped oscillator", hard_cases::oscillator(100.0, hard_cases::Damping::Projected, 2.0), 1.0},
          {"mean height", hard_cases::meanHeight(10), 1.0},
          {"vibrating dumbbell", hard_cases::vibratingDumbbell(), 1.0},
          {"chain with a wave along", hard_cases::longitudinalChain(), 1.0},
          {"buckling", hard_cases::buckling(100.0, 1e-6), 3.0},
          {"heavy swing", hard_cases::heavySwing(), 1.0},
          {"inverted triangle", hard_cases::invertedTriangle(100.0), 1.0},
          {"stiff drag", hard_cases::stiffDrag(), 1e-2}};
}

std::vector<std::string> adaptiveMethods() {
  std::vector<std::string> ids;
  for (const std::string& id : methodIds()) {
    if (methodInfo(id).adaptive) ids.push_back(id);
  }
  return ids;
}

/// Below it there are too many steps for a test. (On the heavy swing a method resolves a vibration of 14142/s.)
double leastTolerance(const MethodInfo& info, const Problem& problem) {
  const bool fast = problem.name == std::string("heavy swing");
  if (info.implicit) return info.order < 4 ? fast ? 1e-5 : 1e-6 : 1e-8;
  return info.order < 4 ? fast ? 1e-5 : 1e-8 : 0.0;
}

/// How many times the least error of all looser tolerances an error may be.
constexpr double mostGrowth = 5.0;

/// The error of a method at a tolerance. Where stability binds the step, a step too long by a rounding lets the fast
/// vibration rise until the estimate sees it, and how far is luck: on the heavy swing, starts that differ by 1e-9 of a
/// length have errors from 2e-5 to 9e-4 at 1e-2 and from 2e-6 to 7e-6 at 3e-4. There it is the median of several
/// starts.
double errorAt(const std::string& method, const Problem& problem, double tolerance, const Trajectory& exact) {
  const bool isLuck = problem.name == std::string("heavy swing") && tolerance > 1e-5;
  std::vector<double> errors;
  for (int start = 0; start < (isLuck ? 5 : 1); ++start) {
    Model model = problem.model;
    for (ModelNode& node : model.nodes) node.x *= 1.0 + 1e-9 * start;
    const std::unique_ptr<ModelSystem> system = build(model);
    errors.push_back(errorOver(*system, runAtTolerance(*system, method, tolerance, problem.duration), exact));
  }
  std::ranges::sort(errors);
  return errors[errors.size() / 2];
}

class Sweep : public ::testing::TestWithParam<std::string> {};

TEST_P(Sweep, ATighterToleranceNeverCostsAccuracy) {
  const MethodInfo& info = methodInfo(GetParam());
  for (const Problem& problem : smoothProblems()) {
    const std::unique_ptr<ModelSystem> system = build(problem.model);
    const Drag* drag = system->drag();
    const bool onlyDrag = info.needs.dragAside && drag != nullptr && !drag->remainderUsesVelocity();
    if (info.needs.velocityFreeForce && system->forceUsesVelocity() && !onlyDrag) continue;
    const Trajectory exact = runAtTolerance(*system, "dop853", 1e-14, problem.duration);
    double least = std::numeric_limits<double>::infinity();
    for (int i = 4; i <= 22; ++i) {
      const double tolerance = std::pow(10.0, -0.5 * i);
      if (tolerance < 0.99 * leastTolerance(info, problem)) break;
      const double error = errorAt(GetParam(), problem, tolerance, exact);
      if (error > 1e-11) {
        EXPECT_LE(error, mostGrowth * least) << problem.name << " at tolerance " << tolerance;
      }
      least = std::min(least, error);
      if (std::getenv("MUELLE_SHOW") != nullptr)
        std::printf("%s %s %.2g %.2g\n", GetParam().c_str(), problem.name, tolerance, error);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Adaptive, Sweep, ::testing::ValuesIn(adaptiveMethods()),
                         [](const auto& param) { return param.param; });

}  // namespace
}  // namespace muelle::lab
