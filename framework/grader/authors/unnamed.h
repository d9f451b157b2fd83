#pragma once
#include "grader/verdict.h"

#include <optional>
#include <string>
#include <vector>

namespace muelle::grader {

/// A function whose wrong answers cost a criterion for which no mistake was named.
struct UnnamedMistake {
  std::string function;
  std::vector<WrongAnswer> answers;       ///< of all those criteria; none unless graded for authors
  std::optional<CounterExample> example;  ///< the simplest call that shows it
};

/// Those of one graded exercise. A function that is built on a wrong one (`follows`) is none of them: what is unnamed
/// is the lower one's mistake.
std::vector<UnnamedMistake> unnamedMistakes(const GradedExercise& exercise);

}  // namespace muelle::grader
