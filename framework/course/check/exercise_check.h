#pragma once
#include "course/check/outcome.h"
#include "course/check/student_program.h"
#include "course/manifest.h"
#include "course/testing/mismatch.h"

#include <string>
#include <vector>

namespace muelle {

/// A public test that failed.
struct FailedTest {
  std::string suite;  ///< a criterion's
  std::string name;
  std::string property;               ///< what the test asks for, in a sentence; "" when it says none
  std::string call;                   ///< the call, to paste: "springForce(1, 0, 10, 1)"; "" when none was made
  std::vector<Mismatch> mismatches;   ///< the numbers that were off
  std::vector<std::string> messages;  ///< what else went wrong: an exception, what the crash was
  Outcome outcome = Outcome::Wrong;
};

/// A function each of whose numbers is the same multiple of the right one, or off by the same (common_mistake.h).
struct CommonFinding {
  std::string function;
  double factor = 1.0;
  double difference = 0.0;
};

/// What the public tests say about a program.
struct TestReport {
  int total = 0;
  int passed = 0;
  int notRun = 0;                    ///< behind tests that ended the program, when time was up
  std::vector<FailedTest> failures;  ///< in the order of the tests
  std::vector<CommonFinding> findings;
  std::string crash;   ///< why the program first ended early; "" when it did not
  std::string output;  ///< what the student's code printed; untrusted text
  /// Of all tests together: a crash before memory never written before a wrong answer.
  Outcome outcome = Outcome::Wrong;

  bool allPassed() const { return crash.empty() && failures.empty() && total > 0 && passed == total; }
};

/// The class to which a check belongs, as `grade` would sort it on the same inputs: that of the build when it failed.
Outcome checkOutcome(const StudentProgram& program, const TestReport& report);

/// Runs the public tests of a built program, what follows a test that ends it in a process of its own; and of its
/// sanitised build, when there is one, of which only what it confirms counts, in the tests that show it. Throws
/// std::runtime_error when the machine is too busy for a verdict.
TestReport runPublicTests(const StudentProgram& program);

/// What the demo left.
struct CurvesReport {
  std::vector<std::filesystem::path> figures;
  std::string trouble;  ///< why there are none, or not all; "" when all is well
};

/// The mistakes that the numbers of the public tests show as they are: those of the manifest in its order and words,
/// then what no manifest need list. None when memory was never written or the program crashed: then numbers are luck.
std::vector<Misconception> namedMistakes(const TestReport& report, const Manifest& manifest);

/// Runs the demo of a built program and draws its curves into `folder`.
CurvesReport drawCurves(const StudentProgram& program, const std::filesystem::path& folder);

/// "4 of 9 public tests pass", and how many were not run.
std::string countTests(const TestReport& report);

/// What one case of a failed test looks like on a terminal: the property, the call to paste, got and expected.
std::string showFailure(const FailedTest& failure);

}  // namespace muelle
