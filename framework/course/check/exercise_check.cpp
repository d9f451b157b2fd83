#include "course/check/exercise_check.h"

#include "base/text/printable.h"
#include "course/check/drawn_figures.h"
#include "course/check/fault_sentences.h"
#include "course/check/report_line.h"
#include "course/check/report_reader.h"
#include "course/check/sanitizer_report.h"
#include "course/check/test_processes.h"
#include "course/testing/common_mistake.h"

#include <fmt/format.h>
#include <algorithm>
#include <map>
#include <stdexcept>

namespace muelle {

namespace {

/// What the sanitizers have confirmed in one process: the test that ran, and its last call.
FailedTest confirmedIn(const TestProcess& process, const std::vector<StudentFile>& students) {
  FailedTest found;
  for (const auto& [kind, text] : process.lines) {
    if (kind == "test") found = testNamed(text);
    if (kind == "call") found.call = text;
  }
  const SanitizerFinding finding = explainSanitizers(process.result.out, students);
  if (!finding.sentence.empty()) found.messages.push_back(finding.sentence);
  found.outcome = finding.outcome;
  return found;
}

/// How the tests of all processes ended, by "Suite.Name"; of each the last call.
class TestEnds {
 public:
  /// \param isFirst leaves out the tests of which it is known that they have met what was never written
  explicit TestEnds(bool isFirst) : knows_(isFirst) {}

  void take(const TestProcess& process) {
    for (const auto& [kind, text] : process.lines) {
      if (kind == "test") {
        running_ = text;
        passed_[running_] = false;  // until it says so
      }
      if (kind == "call" && !text.empty() && !running_.empty()) calls_[running_] = text;
      if (kind == "outcome" && saysNothing(outcomeNamed(text))) passed_.erase(running_);
      if (kind == "end" && text == "passed") passed_[running_] = true;
    }
    if (isMachines(process)) passed_.erase(running_);
  }
  std::optional<bool> passed(const std::string& test) const {
    const auto found = passed_.find(test);
    return found == passed_.end() ? std::nullopt : std::optional(found->second);
  }
  const std::map<std::string, bool>& all() const { return passed_; }
  std::string call(const std::string& test) const {
    const auto found = calls_.find(test);
    return found == calls_.end() ? "" : found->second;
  }

 private:
  /// What a limit or the machine has ended says nothing about the fill; what is known to be the fill needs no more.
  bool saysNothing(Outcome outcome) const {
    return outcome == Outcome::Cpu || outcome == Outcome::Struck || (knows_ && outcome == Outcome::NeverWritten);
  }

  std::map<std::string, bool> passed_;
  std::map<std::string, std::string> calls_;
  std::string running_;
  bool knows_;
};

/// Runs the tests with the other fill of what was never written. One that passes with one fill and fails with the other
/// has done so by luck.
void lookAtOtherFill(const StudentProgram& program, const TestEnds& first, ReportReader& reader) {
  if (program.refilled.empty()) return;
  TestEnds second(false);
  runTests({program.refilled.string(), "tests", "refilled"}, isInstrumented, program.callSeconds,
           [&second](const TestProcess& process) { second.take(process); });
  for (const auto& [name, passed] : first.all()) {
    if (second.passed(name).value_or(passed) == passed) continue;
    FailedTest found = testNamed(name);
    found.call = passed ? second.call(name) : first.call(name);
    const std::string function = found.call.substr(0, found.call.find('('));
    found.messages.push_back(fmt::format("{} {}", function.empty() ? "your code" : function, luckSentence));
    found.outcome = Outcome::NeverWritten;
    reader.confirm(found);
  }
}

/// Adds what the sanitizers find in the second build. How it ends otherwise says nothing: everything is dearer there.
void lookAgain(const StudentProgram& program, ReportReader& reader) {
  if (program.sanitized.empty()) return;
  const auto take = [&](const TestProcess& process) {
    const FailedTest found = confirmedIn(process, program.students);
    if (!found.messages.empty()) reader.confirm(found);
  };
  runTests({program.sanitized.string(), "tests", "slowly"}, Instrumented::Yes, program.callSeconds, take);
}

}  // namespace

Outcome checkOutcome(const StudentProgram& program, const TestReport& report) {
  return program.outcome == Outcome::Passed ? report.outcome : program.outcome;
}

TestReport runPublicTests(const StudentProgram& program) {
  TestReport report;
  ReportReader reader(report, program.callSeconds);
  TestEnds ends(true);
  const auto take = [&](const TestProcess& process) {
    if (process.result.timedOut) {
      throw std::runtime_error(fmt::format(
          "the tests did not end within {} s, nor took the processor time: the machine is too busy, or they "
          "wait for something; try again",
          testsWallSeconds));
    }
    for (const auto& [kind, text] : process.lines) reader.take(kind, text);
    reader.close(process.result);
    ends.take(process);
    report.output +=
        process.result.out.substr(0, studentOutputLimit - std::min(studentOutputLimit, report.output.size()));
  };
  runTests({program.executable.string(), "tests"}, isInstrumented, program.callSeconds, take);
  lookAtOtherFill(program, ends, reader);
  lookAgain(program, reader);
  report.outcome = reader.outcome();
  return report;
}

std::vector<Misconception> namedMistakes(const TestReport& report, const Manifest& manifest) {
  std::vector<Misconception> named;
  if (report.outcome != Outcome::Wrong) return named;
  for (const Misconception& known : manifest.misconceptions) {
    const auto shows = [&known](const CommonFinding& finding) {
      return finding.function == known.function && commonFactor(known.id) == finding.factor;
    };
    if (std::ranges::any_of(report.findings, shows)) named.push_back(known);
  }
  for (const CommonFinding& finding : report.findings) {
    const bool isNamed = std::ranges::find(named, finding.function, &Misconception::function) != named.end();
    const bool isFactor = finding.difference == 0.0;
    const std::string says = isFactor ? factorSentence(finding.factor, finding.function)
                                      : differenceSentence(finding.difference, finding.function);
    if (!isNamed && !says.empty()) named.push_back({isFactor ? "factor" : "term", finding.function, says, ""});
  }
  return named;
}

CurvesReport drawCurves(const StudentProgram& program, const std::filesystem::path& folder, const std::string& remark) {
  std::filesystem::create_directories(folder);
  removeDrawnFigures(folder);
  std::vector<std::string> command = {program.executable.string(), "demo", folder.string()};
  if (!remark.empty()) command.push_back(remark);
  const CommandResult result = runStudentProgram(command, isInstrumented, program.callSeconds);
  CurvesReport curves;
  bool done = false;
  for (const auto& [kind, text] : readReport(result.report)) {
    if (kind == "figure") curves.figures.push_back(folder / text);
    if (kind == "crash") curves.trouble = printableText(text);
    if (kind == "done") done = true;
  }
  noteDrawnFigures(folder, curves.figures);
  if (result.timedOut) curves.trouble = fmt::format("the demo did not end within {} s", testsWallSeconds);
  if (!done && curves.trouble.empty()) curves.trouble = "the demo ended early";
  return curves;
}

}  // namespace muelle
