#pragma once
#include "lab/hard_cases/variant.h"

#include <string>
#include <vector>

namespace muelle::hard_cases {

enum class Expectation { Passes, Fails, NotApplicable };

/// What is expected of a method on a variant, before it runs.
struct Prediction {
  Expectation expectation = Expectation::Passes;
  int rule = 0;        ///< index into predictionRules()
  double error = 0.0;  ///< foreseen, in the variant's measure; 0: nothing but rounding; infinite: grows without bound
  std::string text;    ///< one line with the numbers: "h omega = 16.7 beyond its limit of 2"
};

/// The rules from which all predictions follow, in the order in which they are asked.
struct PredictionRule {
  std::string name;
  std::string reason;
};
const std::vector<PredictionRule>& predictionRules();

/// Most force evaluations that a cell may spend; ten times as many with a fixed step, whose number is known.
inline constexpr long long cellBudget = 3'000'000;

/// Predicts from the method's MethodInfo, the case's facts (see completeFacts()) and the system's capabilities. Never
/// runs the method on the case: at most on a single mode of it.
Prediction predict(const engine::MethodInfo& method, const Variant& variant, const engine::DynamicalSystem& system,
                   double duration, long long budget);

}  // namespace muelle::hard_cases
