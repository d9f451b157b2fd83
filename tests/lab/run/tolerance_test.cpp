/// \file
/// What a tolerance is worth: a tighter one never costs accuracy. (The figure tolerance_against_error shows it.)

#include "engine/integrators/catalogue.h"
#include "engine/model/model_system.h"
#include "lab/hard_cases/models.h"
#include "lab/run/tolerance_sweep.h"

#include <gtest/gtest.h>
#include <cmath>
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
          {"hanging chain", hard_cases::hangingChain(), 1.0}};
}

class Sweep : public ::testing::TestWithParam<const char*> {};

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
      if (info.order < 4 && tolerance < 1e-8) break;  // too many steps for a test
      const double error = errorOver(*system, runAtTolerance(*system, GetParam(), tolerance, problem.duration), exact);
      if (error > 1e-11) {
        EXPECT_LE(error, 5.0 * least) << problem.name << " at tolerance " << tolerance;
      }
      least = std::min(least, error);
      if (std::getenv("MUELLE_SHOW") != nullptr)
        std::printf("%s %s %.2g %.2g\n", GetParam(), problem.name, tolerance, error);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Adaptive, Sweep,
                         ::testing::Values("dormand_prince_5", "dop853", "nystrom8", "nystrom12", "rkc2"),
                         [](const auto& param) { return std::string(param.param); });

}  // namespace
}  // namespace muelle::lab
