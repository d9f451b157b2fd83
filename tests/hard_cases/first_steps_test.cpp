/// \file
/// The matrix in a quick form: every method on every variant for a few steps. For the sanitizers, under which whole
/// cells would take hours, and for what holds of any run: it ends well or says why, and no number is anything but
/// finite.

#include "engine/integrators/catalogue.h"
#include "lab/hard_cases/variant.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace muelle::hard_cases {
namespace {

constexpr double steps = 12.0;
/// Of a cell: what adaptive methods take at starts that are stiff, and where rejected steps pile up.
constexpr long long mostEvaluations = 3000;

engine::RunOptions shortRun(const engine::MethodInfo& method, const Variant& variant) {
  const double h = variant.steps.of(method);
  const double duration = std::min(variant.duration, steps * h);
  engine::RunOptions options =
      method.adaptive ? withTolerance(variant.steps.toleranceOf(method), duration) : fixedStep(h, duration);
  options.mostForceEvaluations = mostEvaluations;
  // Outputs between the steps, so that dense output is run, too.
  options.keepStates = true;
  options.outputInterval = duration / 7.0;
  return options;
}

bool isFinite(const std::vector<double>& values) {
  return std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
}

/// Runs the cell; whether the method took the system.
bool runBriefly(const std::string& id, const Variant& variant) {
  SCOPED_TRACE(id + " on " + variant.label());
  const auto method = engine::makeMethod(id);
  Finished end;
  end.system = engine::build(variant.model);
  const engine::RunOptions options = shortRun(method->info(), variant);
  try {
    end.result = engine::simulate(*end.system, *method, end.system->initialState(), options);
  } catch (const std::invalid_argument& refusal) {
    EXPECT_GT(std::string(refusal.what()).size(), 20U) << "a refusal says why";
    return false;
  }
  EXPECT_TRUE(isFinite(end.result.last.x) && isFinite(end.result.last.v));
  for (const auto& x : end.result.trajectory.x) EXPECT_TRUE(isFinite(x));
  EXPECT_EQ(end.result.failed(), !end.result.trajectory.stop.message.empty());
  EXPECT_TRUE(end.result.failed() || end.result.work.steps >= 1);
  if (variant.error) variant.error(end);
  return true;
}

TEST(FirstSteps, OfEveryMethodOnEveryVariantAreFiniteOrExplained) {
  int taken = 0, refused = 0;
  for (const Variant& variant : allVariants()) {
    for (const std::string& id : engine::methodIds()) ++(runBriefly(id, variant) ? taken : refused);
  }
  EXPECT_GT(taken, 4 * refused) << "most methods take most systems";
}

}  // namespace
}  // namespace muelle::hard_cases
