#include "grader/testing/recorder.h"

#include "course/testing/mismatch.h"

#include <string_view>

namespace muelle::grader {

namespace {

constexpr std::size_t mostMismatches = 5;

/// GoogleTest's own words around an exception or a comparison are for programmers; the first line is enough, and a
/// fault of the submission is told once, in the verdict.
std::string firstLine(const char* message) {
  const std::string_view text(message);
  const std::string line(text.substr(0, text.find('\n')));
  return line.empty() ? "failed" : line;
}

/// What the failed expectation found, or its message where it compared no numbers.
Mismatch mismatchOf(const ::testing::TestPartResult& part, const std::string& call) {
  const std::optional<Mismatch> compared = takeMismatch(part.message());
  Mismatch mismatch = compared.value_or(Mismatch());
  if (!compared) mismatch.says = asStudentsWrite(firstLine(part.message()));
  mismatch.call = call;
  return mismatch;
}

/// What a test has noted under that name.
std::optional<std::string> noted(const ::testing::TestInfo& info, std::string_view name) {
  const ::testing::TestResult& result = *info.result();
  for (int i = 0; i < result.test_property_count(); ++i) {
    if (result.GetTestProperty(i).key() == name) return result.GetTestProperty(i).value();
  }
  return std::nullopt;
}

/// The sentence of MUELLE_PROPERTY, or the test's name.
std::string propertyOf(const ::testing::TestInfo& info) { return noted(info, "property").value_or(info.name()); }

/// What noteSeen() has noted.
SeenMistake seenIn(const ::testing::TestInfo& info) {
  const std::string text = noted(info, "seen").value_or("");
  const std::size_t space = text.find(' ');
  return space == std::string::npos ? SeenMistake() : SeenMistake{text.substr(0, space), text.substr(space + 1)};
}

}  // namespace

void Recorder::OnTestStart(const ::testing::TestInfo&) {
  current_ = TestOutcome();
  session_.forgetLastCall();
}

void Recorder::OnTestPartResult(const ::testing::TestPartResult& part) {
  if (!part.failed()) return;
  if (current_.call.empty()) current_.call = session_.lastCall();
  if (session_.hasFailed() || !session_.graderFault().empty()) return;
  const bool exception = std::string_view(part.message()).starts_with("C++ exception");
  if (exception) session_.noteGraderFault("a hidden test threw: " + std::string(part.message()));
  if (current_.mismatches.size() < mostMismatches) current_.mismatches.push_back(mismatchOf(part, session_.lastCall()));
}

void Recorder::OnTestEnd(const ::testing::TestInfo& info) {
  current_.name = info.name();
  current_.property = propertyOf(info);
  current_.passed = info.result()->Passed();
  current_.seen = seenIn(info);
  called_.resize(verdict_.tests.size());  // what the record had before has called nothing
  verdict_.tests.push_back(current_);
  called_.push_back(session_.called());
}

/// A test that has believed a function of changing answers has not passed.
void Recorder::withdraw() {
  for (std::size_t i = 0; i < called_.size(); ++i) {
    for (const std::string& function : session_.unreliable()) {
      if (called_[i].contains(function)) verdict_.tests[i].passed = false;
    }
  }
}

void Recorder::OnTestProgramEnd(const ::testing::UnitTest& program) {
  withdraw();
  const bool isClean = session_.fault().empty() && session_.graderFault().empty();
  if (isClean && program.Passed() && !verdict_.tests.empty()) verdict_.outcome = Outcome::Passed;
}

}  // namespace muelle::grader
