#pragma once
#include "grader/verdict.h"

#include <string>
#include <vector>

namespace muelle::grader {

/// Why a criterion got what it got, as far as the manifest's level lets a student know. Every text is printable.
struct Explanation {
  enum class State { Passed, Partial, Failed, NotRun, GraderFault };
  struct Mistake {
    std::string says;
    std::string hint;
  };
  struct FailedTest {
    std::string name;
    std::string property;
    std::string call;
    std::vector<std::string> details;
  };

  State state = State::NotRun;
  std::string instead;            ///< one line when there is no verdict to explain: not built, not run, grader at fault
  std::vector<Mistake> mistakes;  ///< misconceptions whose numbers match
  std::string fault;              ///< crash, time-out, forbidden call
  std::vector<FailedTest> tests;  ///< failed ones
  std::string hint;               ///< the criterion's, when no mistake was named
};

Explanation explain(const Criterion& criterion, const GradedExercise& exercise);

/// What the student's code printed for this criterion; "" below level Values, since a function can print its inputs.
std::string shownOutput(const Criterion& criterion, const GradedExercise& exercise);

}  // namespace muelle::grader
