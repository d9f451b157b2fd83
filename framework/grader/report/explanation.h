#pragma once
#include "course/testing/mismatch.h"
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
  /// A failed expectation: its numbers in words.
  struct Failure {
    std::string call;      ///< with its inputs; "" when it is that of the failure before, or there was none
    MismatchWords words;   ///< in parts
    std::string sentence;  ///< the parts in one line; "" when only the call is known
  };
  struct FailedTest {
    std::string name;
    std::string property;
    std::vector<Failure> failures;
    std::string more;  ///< "... and 3 more"; "" when all are shown
  };

  State state = State::NotRun;
  std::string instead;            ///< one line when there is no verdict to explain: not built, not run, grader at fault
  std::string neverWritten;       ///< what was returned is memory to which nothing was written: said before any mistake
  std::vector<Mistake> mistakes;  ///< misconceptions whose numbers match
  std::string fault;              ///< crash, time-out, forbidden call
  std::vector<std::string> examples;  ///< calls to check on paper, a line each; only at level Values
  std::vector<FailedTest> tests;      ///< failed ones
  std::string hint;                   ///< the criterion's, when no mistake was named
  std::string note;                   ///< how the exercise's file was taken; "" when under its own name

  /// Whether it is known what the code does wrong, besides its numbers.
  bool hasCause() const { return !neverWritten.empty() || !mistakes.empty() || !fault.empty(); }
};

Explanation explain(const Criterion& criterion, const GradedExercise& exercise);

/// What the student's code printed for this criterion; "" below level Values, since a function can print its inputs.
std::string shownOutput(const Criterion& criterion, const GradedExercise& exercise);

}  // namespace muelle::grader
