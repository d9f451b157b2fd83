#pragma once
#include "course/check/outcome.h"
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
  std::vector<std::string> notRun;   ///< "Suite.Name", behind tests that ended the program, when time was up
  std::vector<FailedTest> failures;  ///< in the order of the tests
  std::vector<CommonFinding> findings;
  std::string crash;   ///< why the program first ended early; "" when it did not
  std::string output;  ///< what the student's code printed; untrusted text
  /// Of all tests together: a crash before memory never written before a wrong answer.
  Outcome outcome = Outcome::Wrong;

  bool allPassed() const { return crash.empty() && failures.empty() && total > 0 && passed == total; }
};

/// "4 of 9 public tests pass", and which were not run.
std::string countTests(const TestReport& report);

/// What one case of a failed test looks like on a terminal: the property, the call to paste, got and expected.
std::string showFailure(const FailedTest& failure);

}  // namespace muelle
