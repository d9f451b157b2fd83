#pragma once
#include "base/process/child.h"
#include "course/check/test_report.h"
#include "course/time_limits.h"

#include <string>
#include <vector>

namespace muelle {

/// A test, before anything is known of it, from its "Suite.Name".
FailedTest testNamed(const std::string& fullName);

/// Builds the report from what the public test program wrote.
class ReportReader {
 public:
  /// \param callSeconds processor time that one call may take
  explicit ReportReader(TestReport& report, int callSeconds = usualCallSeconds)
      : report_(report), callSeconds_(callSeconds) {}

  /// A line of the report of the process that runs.
  void take(const std::string& kind, const std::string& text);

  /// At the end of a process. A test that began and did not end is the one that crashed.
  void close(const CommandResult& result);

  /// Makes what a test of the second look has confirmed the first word about it. Of no test, when the student's file
  /// is loaded: then about all.
  void confirm(const FailedTest& found);

  /// Of the first failure that ended the calls, else of memory that was never written, else a wrong answer: as the
  /// grader sorts the tests of a criterion. Of the crash when it was outside of every test.
  Outcome outcome() const;

 private:
  void explainAbort(const std::string& output);
  FailedTest& fail(std::size_t place);
  void takeMismatch(const std::string& text);
  void takeFinding(double CommonFinding::*kind, const std::string& text);
  void begin(const std::string& fullName);
  void end(bool passed);
  std::string describe(const CommandResult& result) const;

  TestReport& report_;
  int callSeconds_;
  FailedTest current_;
  std::vector<std::string> planned_;  ///< all tests of the program
  std::vector<FailedTest> begun_;     ///< all tests that have, with their property when they have ended
  std::string crash_;                 ///< of this process
  bool isLater_ = false;              ///< another process than the first
  bool running_ = false;
  bool done_ = false;
  bool hasOutcome_ = false;  ///< of the test that runs
  Outcome lastOutcome_ = Outcome::Crash;
};

}  // namespace muelle
