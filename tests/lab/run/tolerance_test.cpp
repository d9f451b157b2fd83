/// \file
/// What a tolerance is worth: a tighter one never costs accuracy. The error is that of the whole run, for at one
/// instant amplitude and phase can cancel.

#include "engine/control/motion_frame.h"
#include "engine/control/simulate.h"
#include "engine/integrators/catalogue.h"
#include "engine/model/model_system.h"
#include "lab/hard_cases/models.h"

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

Trajectory run(const ModelSystem& system, const char* id, double tolerance, double duration) {
  RunOptions options;
  options.duration = duration;
  options.tolerance.relative = tolerance;
  constexpr int outputs = 400;
  for (int i = 1; i <= outputs; ++i) options.sampleTimes.push_back(duration * i / outputs);
  const std::unique_ptr<Integrator> method = makeMethod(id);
  return simulate(system, *method, system.initialState(), options).trajectory;
}

/// Largest difference of positions at the outputs, in parts of the motion.
double errorOf(const ModelSystem& system, const Trajectory& path, const Trajectory& exact) {
  if (path.stop.stopped) return std::numeric_limits<double>::infinity();
  MotionFrame frame(system, {0.0, exact.x[0], exact.v[0], {}});
  double size = 0.0, off = 0.0;
  for (std::size_t row = 0; row < exact.t.size(); ++row) {
    size = std::max(size, frame.sizeAt(system, {exact.t[row], exact.x[row], exact.v[row], {}}).position);
    for (std::size_t i = 0; i < exact.x[row].size(); ++i)
      off = std::max(off, std::abs(path.x[row][i] - exact.x[row][i]));
  }
  return off / size;
}

class Sweep : public ::testing::TestWithParam<const char*> {};

TEST_P(Sweep, ATighterToleranceNeverCostsAccuracy) {
  const MethodInfo& info = methodInfo(GetParam());
  for (const Problem& problem : smoothProblems()) {
    const std::unique_ptr<ModelSystem> system = build(problem.model);
    if (info.needs.velocityFreeForce && system->forceUsesVelocity()) continue;
    const Trajectory exact = run(*system, "dop853", 1e-14, problem.duration);
    double least = std::numeric_limits<double>::infinity();
    for (int i = 4; i <= 22; ++i) {
      const double tolerance = std::pow(10.0, -0.5 * i);
      if (info.order < 4 && tolerance < 1e-8) break;  // too many steps for a test
      const double error = errorOf(*system, run(*system, GetParam(), tolerance, problem.duration), exact);
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
