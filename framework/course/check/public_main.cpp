/// \file
/// The program that the student's check runs: the public tests, or the demo, on the student's functions.
///
///     program tests          runs the tests; --gtest_filter=-SUITE.TEST:SUITE.TEST leaves some out
///     program tests slowly   the same, in the build with sanitizers (sanitizedFactor)
///     program tests refilled the same, in the build with another fill of what was never written
///     program demo FOLDER    draws the demo's figures into the folder
///
/// What happens goes to descriptor 3 as report lines (report_line.h), whatever the student's code prints or breaks.

#include "course/check/crash_report.h"
#include "course/check/eigen_message.h"
#include "course/check/missing_functions.h"
#include "course/check/outcome.h"
#include "course/check/report_line.h"
#include "course/check/standard_message.h"
#include "course/check/thrown_sentence.h"
#include "course/testing/call_record.h"
#include "course/testing/common_mistake.h"
#include "course/testing/mismatch_text.h"
#include "course/testing/never_written.h"
#include "figures/write.h"
#include "harness/demo.h"

#include <gtest/gtest.h>
#include <unistd.h>
#include <cstdio>
#include <exception>
#include <iostream>
#include <string>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace muelle {

namespace {

/// "springForce" while it runs; afterwards, when a test handles what it returned, "what springForce returned".
std::string place() {
  if (CallRecord::current() != nullptr) return CallRecord::current()->function();
  const std::string& call = CallRecord::lastCall();
  return call.empty() ? "" : "what " + call.substr(0, call.find('(')) + " returned";
}

std::string nameOf(const testing::TestInfo& test) { return std::string(test.test_suite_name()) + "." + test.name(); }

class ReportingListener : public testing::EmptyTestEventListener {
  void OnTestProgramStart(const testing::UnitTest& program) override {
    for (int i = 0; i < program.total_test_suite_count(); ++i) plan(*program.GetTestSuite(i));
  }
  void OnTestStart(const testing::TestInfo& test) override {
    CallRecord::setLastCall("");
    CallRecord::neverWritten().clear();
    CallRecord::badQuestion().clear();
    lastMisuse().clear();
    report("test", nameOf(test));
  }
  void OnTestPartResult(const testing::TestPartResult& part) override {
    if (!part.failed()) return;
    report("call", CallRecord::lastCall());
    // Before any other name: what the numbers look like is luck.
    if (std::string& function = CallRecord::neverWritten(); !function.empty()) {
      report("outcome", nameOf(Outcome::NeverWritten));
      report("failure", function + " " + neverWrittenSentence());
      function.clear();
    } else if (!lastMisuse().empty()) {
      const Outcome outcome = misuseOfFill() ? Outcome::NeverWritten : Outcome::Crash;
      report("outcome", nameOf(callsMissing() ? Outcome::Link : outcome));
    }
    if (std::optional<Mismatch> mismatch = takeMismatch(part.message())) {
      mismatch->call = CallRecord::lastCall();
      return report("mismatch", mismatchText(*mismatch));
    }
    report("failure", withoutExceptionPhrase(part.message()));
    lastMisuse().clear();
  }
  void OnTestEnd(const testing::TestInfo& test) override {
    const testing::TestResult& result = *test.result();
    for (int i = 0; i < result.test_property_count(); ++i) {
      const testing::TestProperty& property = result.GetTestProperty(i);
      if (std::string(property.key()) == "property") report("property", property.value());
    }
    report("end", result.Passed() ? "passed" : "failed");
  }
  void OnTestProgramEnd(const testing::UnitTest&) override {
    for (const auto& [function, answers] : comparedAnswers()) {
      if (const std::optional<double> factor = answers.factor()) {
        report("factor", exactText(*factor) + " " + function);
      } else if (const std::optional<double> difference = answers.difference()) {
        report("difference", exactText(*difference) + " " + function);
      }
    }
  }

  /// So that check knows what a test that ends the process leaves.
  static void plan(const testing::TestSuite& suite) {
    for (int i = 0; i < suite.total_test_count(); ++i) {
      const testing::TestInfo& test = *suite.GetTestInfo(i);
      if (test.should_run()) report("planned", nameOf(test));
    }
  }

  /// GoogleTest wraps an exception's text in words about itself.
  static std::string withoutExceptionPhrase(const std::string& message) {
    const std::string& call = CallRecord::lastCall();
    const std::string function = call.empty() ? "the test" : call.substr(0, call.find('('));
    if (message.starts_with("Unknown C++ exception")) return function + " " + thrownSentence("");
    const std::string before = "C++ exception with description \"";
    const std::size_t end = message.rfind("\" thrown in");
    if (!message.starts_with(before) || end == std::string::npos) return message;
    const std::string what = message.substr(before.size(), end - before.size());
    if (what == lastMisuse()) return what;
    if (what == CallRecord::badQuestion()) return function + " " + what;  // as the grader says it
    return function + " " + thrownSentence(what);
  }

 public:
  /// What is longer than anybody reads is cut: the report has a bound.
  static void report(std::string_view kind, std::string_view text) {
    constexpr std::size_t longest = 8192;
    writeReport(reportLine(kind, text.substr(0, longest)));
  }
  /// The text of the latest EigenMisuse: GoogleTest keeps only the text of an exception.
  static std::string& lastMisuse() {
    static std::string text;
    return text;
  }
  /// Whether it was a call of a function that is missing.
  static bool& callsMissing() {
    static bool isMissing = false;
    return isMissing;
  }
  /// Whether it was an index that was never written.
  static bool& misuseOfFill() {
    static bool isFill = false;
    return isFill;
  }
};

int runTests(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  testing::TestEventListeners& listeners = testing::UnitTest::GetInstance()->listeners();
  delete listeners.Release(listeners.default_result_printer());
  listeners.Append(new ReportingListener);
  return RUN_ALL_TESTS();
}

/// \param remark behind the title of the first figure; "" for none
int drawDemo(const std::string& folder, const std::string& remark) {
  // A demo calls thousands of times; its arguments are of no use.
  CallRecord::printsArguments() = false;
  try {
    std::vector<Figure> figures = muelleDemo();
    if (!remark.empty() && !figures.empty()) figures.front() = figures.front().withRemark(remark);
    for (const Figure& figure : figures) {
      writeFigure(figure, folder);
      ReportingListener::report("figure", figure.id() + ".svg");
    }
  } catch (const std::exception& error) {
    ReportingListener::report("crash", "the demo " + thrownSentence(textOf(error)));
    return 1;
  }
  return 0;
}

}  // namespace

/// An exception, so that the other tests still run.
void eigenAssertionFailed(const char* condition, const char* function, AssertedIndex index) {
  // While an exception is on its way, destructors of Eigen assert what they then find; the first cause is what counts.
  if (std::uncaught_exceptions() == 0) {
    ReportingListener::callsMissing() = function == missingFunction;
    ReportingListener::misuseOfFill() = index.known && isFillInteger(index.value);
    ReportingListener::lastMisuse() =
        ReportingListener::callsMissing() ? condition
        : ReportingListener::misuseOfFill()
            ? "an index was never written in " + place() + ": give every variable a value before it is read"
            : eigenMessage(condition, function, index, place());
  }
  throw EigenMisuse(ReportingListener::lastMisuse());
}

}  // namespace muelle

#ifdef __GLIBCXX__
/// GNU's standard library calls it when one of its own rules is broken, and has one that only prints and aborts.
namespace std {
// NOLINTNEXTLINE(bugprone-reserved-identifier): the standard library calls it by this name
void __glibcxx_assert_fail(const char*, int, const char* function, const char* condition) noexcept {
  muelle::endWithCrash(
      muelle::standardMessage(condition != nullptr ? condition : "", function != nullptr ? function : "").c_str());
}
}  // namespace std
#endif

int main(int argc, char** argv) {
#ifdef __GLIBC__
  // Fresh memory is filled with 0xFE, as GCC fills local variables, or with 0, as it does in the other build.
  const bool isRefilled = argc == 3 && std::string(argv[2]) == "refilled";
  mallopt(M_PERTURB, isRefilled ? 0xFF : 1);
#endif
  std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);  // a crash must not swallow what was printed before it
  muelle::watchForCrashes();
  const bool drawsDemo = (argc == 3 || argc == 4) && std::string(argv[1]) == "demo";
  const int status = drawsDemo ? muelle::drawDemo(argv[2], argc == 4 ? argv[3] : "") : muelle::runTests(argc, argv);
  muelle::ReportingListener::report("done", "");
  std::cout.flush();
  std::fflush(stdout);
  // As the grader's worker ends: what the student's destructors would do after the last answer costs nothing.
  _exit(status);
}
