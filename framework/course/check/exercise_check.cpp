#include "course/check/exercise_check.h"

#include "base/process/child.h"
#include "base/text/printable.h"
#include "course/check/report_line.h"
#include "course/check/standard_check.h"

#include <fmt/format.h>
#include <algorithm>
#include <csignal>
#include <cstring>

namespace muelle {

namespace {

constexpr double runSeconds = 10.0;

/// Without input, in the C locale; both streams together, the report apart.
CommandResult runStudentProgram(const std::vector<std::string>& command) {
  ChildSpec spec;
  spec.command = command;
  spec.inheritsEnvironment = true;
  spec.environment = {"LC_ALL=C"};
  spec.limits.stack = 8U << 20U;  // an endless recursion must meet the end of the stack before the end of the memory
  constexpr std::size_t bytes = 65536;
  return runCommand(spec, {std::chrono::milliseconds(static_cast<long>(1000 * runSeconds)), bytes, 0, bytes, true});
}

/// Builds the report from what the program wrote.
class ReportReader {
 public:
  explicit ReportReader(TestReport& report) : report_(report) {}

  void take(const std::string& kind, const std::string& text) {
    if (kind == "tests") report_.total = std::atoi(text.c_str());
    if (kind == "test") begin(text);
    if (kind == "call" && current_.call.empty()) current_.call = text;
    if (kind == "failure") current_.messages.push_back(text);
    if (kind == "property") current_.property = text;
    if (kind == "crash") report_.crash = text;
    if (kind == "end") end(text == "passed");
    if (kind == "done") done_ = true;
  }

  /// A test that began and did not end is the one that crashed.
  void close(const CommandResult& result) {
    if (!done_ && report_.crash.empty()) report_.crash = describe(result);
    if (!running_) return;
    current_.messages.push_back(report_.crash);
    report_.failures.push_back(current_);
  }

 private:
  void begin(const std::string& fullName) {
    const std::size_t dot = fullName.find('.');
    current_ = FailedTest{};
    current_.suite = fullName.substr(0, dot);
    current_.name = fullName.substr(dot + 1);
    running_ = true;
  }
  void end(bool passed) {
    running_ = false;
    if (passed) {
      ++report_.passed;
    } else {
      report_.failures.push_back(current_);
    }
  }
  static std::string describe(const CommandResult& result) {
    if (result.timedOut) return fmt::format("the tests did not end within {} s", runSeconds);
    if (result.status.signalled)
      return fmt::format("your code was ended by a signal: {}", strsignal(result.status.code));
    return fmt::format("your code ended the program (exit code {}) instead of returning", result.status.code);
  }

  TestReport& report_;
  FailedTest current_;
  bool running_ = false;
  bool done_ = false;
};

/// The standard library's own range checks name the condition only.
std::string explainAbort(const std::string& crash, const std::string& output) {
  constexpr std::string_view aborted = "aborted";
  const std::size_t assertion = output.find("Assertion '");
  if (!crash.ends_with(aborted) || assertion == std::string::npos) return crash;
  const std::string what = standardCheckText(output.substr(assertion));
  return what.empty() ? crash : crash.substr(0, crash.size() - aborted.size()) + what;
}

/// The student's words without those of the standard library's checks, which the crash says better.
std::string withoutAssertions(const std::string& output) {
  std::string kept;
  std::size_t start = 0;
  while (start < output.size()) {
    const std::size_t end = std::min(output.find('\n', start), output.size() - 1) + 1;
    const std::string line = output.substr(start, end - start);
    if (line.find(": Assertion '") == std::string::npos) kept += line;
    start = end;
  }
  return kept;
}

}  // namespace

TestReport runPublicTests(const StudentProgram& program) {
  const CommandResult result = runStudentProgram({program.executable.string(), "tests"});
  TestReport report;
  ReportReader reader(report);
  for (const auto& [kind, text] : readReport(result.report)) {
    reader.take(kind, kind == "crash" ? explainAbort(text, result.out) : text);
  }
  reader.close(result);
  report.output = withoutAssertions(result.out);
  return report;
}

CurvesReport drawCurves(const StudentProgram& program, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  const CommandResult result = runStudentProgram({program.executable.string(), "demo", folder.string()});
  CurvesReport curves;
  bool done = false;
  for (const auto& [kind, text] : readReport(result.report)) {
    if (kind == "figure") curves.figures.push_back(folder / text);
    if (kind == "crash") curves.trouble = printableText(explainAbort(text, result.out));
    if (kind == "done") done = true;
  }
  if (result.timedOut) curves.trouble = fmt::format("the demo did not end within {} s", runSeconds);
  if (!done && curves.trouble.empty()) curves.trouble = "the demo ended early";
  return curves;
}

std::string showFailure(const FailedTest& failure) {
  std::string text;
  if (!failure.property.empty()) text += fmt::format("  {}\n", failure.property);
  if (!failure.call.empty()) text += fmt::format("    {};\n", failure.call);
  // The first message is enough to mend; a test with ten components would hide the rest.
  constexpr std::size_t most = 2;
  for (std::size_t i = 0; i < std::min(most, failure.messages.size()); ++i) {
    std::string message = failure.messages[i];
    // "submission::springForce(xa, xb, k, L0), component 0: got ...": the call above says it with numbers.
    if (message.starts_with("submission::")) {
      const std::size_t got = message.find(": got ");
      const std::size_t component = message.rfind(", component ", got);
      const std::size_t entry = message.rfind(", entry ", got);
      const std::size_t place = component != std::string::npos ? component : entry;
      if (got != std::string::npos && !failure.call.empty()) {
        message = place != std::string::npos ? message.substr(place + 2) : message.substr(got + 2);
      }
    }
    text += indented(message + "\n", "    ");
  }
  return printableText(text);
}

}  // namespace muelle
