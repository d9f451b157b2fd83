#include "course/check/exercise_check.h"

#include "base/process/child.h"
#include "base/text/printable.h"
#include "course/check/compile_rules.h"
#include "course/check/fault_sentences.h"
#include "course/check/heap_damage.h"
#include "course/check/report_line.h"
#include "course/check/sanitizer_report.h"
#include "course/testing/common_mistake.h"
#include "course/testing/mismatch_text.h"

#include <fmt/format.h>
#include <algorithm>
#include <csignal>
#include <cstring>
#include <map>
#include <stdexcept>

namespace muelle {

namespace {

/// Wide: the program counts its own processor time, and ends itself long before on a machine that lets it work.
constexpr int wallSeconds = 60;
constexpr unsigned processorSeconds = 15;

constexpr std::size_t memory = 1UL << 30U;  ///< [bytes] as the grader's

constexpr std::size_t outputLimit = 65536;  ///< [bytes] of what the student's code prints

/// Whether AddressSanitizer is in the program, which reserves more address space than there is memory.
enum class Instrumented { No, Yes };

/// Without input, in the C locale; both streams together, the report apart.
CommandResult runStudentProgram(const std::vector<std::string>& command, Instrumented instrumented) {
  ChildSpec spec;
  spec.command = command;
  spec.inheritsEnvironment = true;
  spec.environment = {
      "LC_ALL=C",
      // The allocator's own cache would hand memory out without filling it.
      "GLIBC_TUNABLES=glibc.malloc.tcache_count=0",
      // After a finding, abort(), of which the program tells with the call.
      "ASAN_OPTIONS=abort_on_error=1:detect_leaks=0:detect_stack_use_after_return=1:detect_container_overflow=0:handle_"
      "segv=0:"
      "handle_abort=0:handle_sigfpe=0:handle_sigill=0:handle_sigbus=0:"
      // Its own bounds of memory, in MiB: of one allocation, and (not on macOS) of all that is resident.
      "max_allocation_size_mb=1024:hard_rss_limit_mb=1024",
  };
#ifndef __APPLE__
  if (instrumented == Instrumented::No) spec.limits.addressSpace = memory;
#endif
  const unsigned factor = instrumented == Instrumented::Yes ? sanitizedFactor : 1;
  spec.limits.cpuSeconds = factor * processorSeconds;
  // An endless recursion must meet the end of the stack before the end of the memory.
  spec.limits.stack = (instrumented == Instrumented::Yes ? sanitizedStackFactor : 1) * (std::size_t{8} << 20U);
  return runCommand(spec, {factor * std::chrono::seconds(wallSeconds), outputLimit, 0, 16 * outputLimit, true});
}

/// Of the plain build: Yes in a build folder that has sanitizers everywhere.
#if defined(__SANITIZE_ADDRESS__)
constexpr Instrumented isInstrumented = Instrumented::Yes;
#else
constexpr Instrumented isInstrumented = Instrumented::No;
#endif

/// A test, before anything is known of it, from its "Suite.Name".
FailedTest testNamed(const std::string& fullName) {
  const std::size_t dot = fullName.find('.');
  FailedTest test;
  test.suite = fullName.substr(0, dot);
  test.name = fullName.substr(dot + 1);
  return test;
}

/// True for a signal that a student's code draws by its own work. It can send itself none but abort()'s, since what
/// does so is refused; a filter of system calls around check raises SIGSYS.
bool isOwnSignal(int signal) { return signalSentence(signal) != nullptr || signal == SIGSYS; }

/// Builds the report from what the program wrote.
class ReportReader {
 public:
  explicit ReportReader(TestReport& report) : report_(report) {}

  void take(const std::string& kind, const std::string& text) {
    if (kind == "tests" && report_.total == 0) report_.total = std::atoi(text.c_str());  // the first process knows all
    if (kind == "test") begin(text);
    if (kind == "call" && current_.call.empty()) current_.call = text;
    if (kind == "mismatch") takeMismatch(text);
    if (kind == "failure") current_.messages.push_back(text);
    if (kind == "property") current_.property = text;
    if (kind == "outcome" && !hasOutcome_) {
      current_.outcome = outcomeNamed(text);
      hasOutcome_ = true;
    }
    if (kind == "factor") takeFinding(&CommonFinding::factor, text);
    if (kind == "difference") takeFinding(&CommonFinding::difference, text);
    if (kind == "crash") crash_ = text;
    if (kind == "end") end(text == "passed");
    if (kind == "done") done_ = true;
  }

  /// At the end of a process. A test that began and did not end is the one that crashed.
  void close(const CommandResult& result) {
    if (!done_ && crash_.empty()) {
      crash_ = describe(result);
      current_.outcome = outcomeOf(result);
    }
    explainAbort(result.out);
    if (running_) {
      current_.messages.push_back(crash_);
      report_.failures.push_back(current_);
    } else if (!done_) {
      lastOutcome_ = current_.outcome;
    }
    if (report_.crash.empty()) report_.crash = crash_;
    report_.notRun = std::max(report_.total - static_cast<int>(begun_.size()), 0);
    crash_.clear();
    running_ = done_ = false;
  }

  /// Makes what a test of the second look has confirmed the first word about it. Of no test, when the student's file
  /// is loaded: then about all.
  void confirm(const FailedTest& found) {
    if (found.name.empty()) {
      report_.passed = 0;
      report_.failures.insert(report_.failures.begin(), found);
      return;
    }
    const std::size_t place = placeOf(found, begun_);
    if (place == begun_.size()) return;  // it had no time to run; another has failed
    const std::size_t failure = placeOf(found, report_.failures);
    FailedTest& test = failure == report_.failures.size() ? fail(place) : report_.failures[failure];
    if (test.call.empty()) test.call = found.call;
    test.messages.insert(test.messages.begin(), found.messages.begin(), found.messages.end());
    test.outcome = found.outcome;
  }

  /// Of the first failure that ended the calls, else of memory that was never written, else a wrong answer: as the
  /// grader sorts the tests of a criterion. Of the crash when it was outside of every test.
  Outcome outcome() const {
    if (report_.allPassed()) return Outcome::Passed;
    if (report_.failures.empty()) return lastOutcome_;
    const auto of = [](const FailedTest& failure) { return failure.outcome; };
    const auto ended = std::ranges::find_if(
        report_.failures, [](Outcome o) { return o != Outcome::Wrong && o != Outcome::NeverWritten; }, of);
    if (ended != report_.failures.end()) return ended->outcome;
    const bool isUnwritten = std::ranges::find(report_.failures, Outcome::NeverWritten, of) != report_.failures.end();
    return isUnwritten ? Outcome::NeverWritten : Outcome::Wrong;
  }

 private:
  /// "twice called abort()": the C library may have said why.
  void explainAbort(const std::string& output) {
    constexpr std::string_view plain = abortSentence;
    const std::string damage = crash_.ends_with(plain) ? heapDamage(output) : "";
    if (!damage.empty()) crash_.replace(crash_.size() - plain.size(), plain.size(), damage);
  }

  /// Beyond the end when it is not among them.
  static std::size_t placeOf(const FailedTest& test, const std::vector<FailedTest>& among) {
    const auto isIt = [&test](const FailedTest& t) { return t.suite == test.suite && t.name == test.name; };
    return static_cast<std::size_t>(std::ranges::find_if(among, isIt) - among.begin());
  }

  /// A test that had passed, now among the failures in the order of the tests. \param place where it began
  FailedTest& fail(std::size_t place) {
    const auto isLater = [&](const FailedTest& test) { return placeOf(test, begun_) > place; };
    --report_.passed;
    return *report_.failures.insert(std::ranges::find_if(report_.failures, isLater), begun_[place]);
  }

  void takeMismatch(const std::string& text) {
    if (const std::optional<Mismatch> mismatch = readMismatch(text)) current_.mismatches.push_back(*mismatch);
  }
  /// "-1 springForce": a factor or a difference
  void takeFinding(double CommonFinding::*kind, const std::string& text) {
    const std::size_t blank = std::min(text.find(' '), text.size());
    const std::optional<double> number = exactNumber(text.substr(0, blank));
    if (!number || blank >= text.size()) return;
    CommonFinding finding{text.substr(blank + 1)};
    finding.*kind = *number;
    report_.findings.push_back(std::move(finding));
  }
  void begin(const std::string& fullName) {
    current_ = testNamed(fullName);
    hasOutcome_ = false;
    running_ = true;
    begun_.push_back(current_);
  }
  void end(bool passed) {
    running_ = false;
    hasOutcome_ = false;
    begun_.back().property = current_.property;
    if (passed) {
      ++report_.passed;
    } else {
      report_.failures.push_back(current_);
    }
  }
  std::string describe(const CommandResult& result) const {
    const std::string who = begun_.empty() ? loadingCode : "your code";
    const char* sentence = result.status.signalled ? signalSentence(result.status.code) : nullptr;
    if (sentence != nullptr) return fmt::format("{} {}", who, sentence);
    if (result.status.signalled && result.status.code == SIGXCPU)
      return fmt::format("the tests took more than {} s of processor time", processorSeconds);
    if (result.status.signalled) return fmt::format("{} was ended by a signal: {}", who, strsignal(result.status.code));
    return fmt::format("{} {}", who, exitSentence(result.status.code));
  }

  static Outcome outcomeOf(const CommandResult& result) {
    if (!result.status.signalled) return Outcome::Crash;
    if (result.status.code == SIGXCPU) return Outcome::Cpu;
    return isOwnSignal(result.status.code) ? Outcome::Crash : Outcome::Killed;
  }

  TestReport& report_;
  FailedTest current_;
  std::vector<FailedTest> begun_;  ///< all tests that have, with their property when they have ended
  std::string crash_;              ///< of this process
  bool running_ = false;
  bool done_ = false;
  bool hasOutcome_ = false;  ///< of the test that runs
  Outcome lastOutcome_ = Outcome::Crash;
};

/// A process of the tests that has ended, and the lines of its report.
struct TestProcess {
  CommandResult result;
  std::vector<std::pair<std::string, std::string>> lines;

  /// "Suite.Name:Suite.Name"
  std::string begun() const {
    std::string names;
    for (const auto& [kind, text] : lines) {
      if (kind == "test") names += (names.empty() ? "" : ":") + text;
    }
    return names;
  }
  /// Whether it did not come to its end, and tests are left.
  bool leavesTests() const {
    long left = 0;
    bool done = result.timedOut;
    for (const auto& [kind, text] : lines) {
      if (kind == "tests") left = std::atol(text.c_str());
      if (kind == "test") --left;
      if (kind == "done") done = true;
    }
    return !done && left > 0;
  }
};

/// Whether it was ended from outside, perhaps, or stopped: then it is run once more.
bool isMachines(const TestProcess& process) {
  const ExitStatus& status = process.result.status;
  if (process.result.timedOut || (status.signalled && !isOwnSignal(status.code))) return true;
  return std::ranges::find(process.lines, std::pair<std::string, std::string>("outcome", nameOf(Outcome::Struck))) !=
         process.lines.end();
}

/// Runs the tests, and hands each process that it takes to `take`: what follows a test that ended its process runs in
/// the next, as long as they have not used up what all calls together may take.
template <class Take>
void runTests(const std::vector<std::string>& command, Instrumented instrumented, const Take& take) {
  constexpr double enough = 10.0;  // [s] of processor time, as all calls together may take
  constexpr auto enoughWall = std::chrono::seconds(20);
  const auto start = std::chrono::steady_clock::now();
  std::string begun;
  double used = 0.0;
  for (bool goesOn = true; goesOn;) {
    std::vector<std::string> words = command;
    if (!begun.empty()) words.push_back("--gtest_filter=-" + begun);
    const auto run = [&] {
      CommandResult result = runStudentProgram(words, instrumented);
      auto lines = readReport(result.report);
      return TestProcess{std::move(result), std::move(lines)};
    };
    TestProcess process = run();
    if (isMachines(process)) process = run();
    take(process);
    used += process.result.status.cpuSeconds;
    const std::string more = process.begun();
    begun += (begun.empty() ? "" : ":") + more;
    const bool hasTime = used < enough && std::chrono::steady_clock::now() - start < enoughWall;
    goesOn = hasTime && !more.empty() && process.leavesTests();
  }
}

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
  runTests({program.refilled.string(), "tests", "refilled"}, isInstrumented,
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
  runTests({program.sanitized.string(), "tests", "slowly"}, Instrumented::Yes, [&](const TestProcess& process) {
    const FailedTest found = confirmedIn(process, program.students);
    if (!found.messages.empty()) reader.confirm(found);
  });
}

}  // namespace

Outcome checkOutcome(const StudentProgram& program, const TestReport& report) {
  return program.outcome == Outcome::Passed ? report.outcome : program.outcome;
}

TestReport runPublicTests(const StudentProgram& program) {
  TestReport report;
  ReportReader reader(report);
  TestEnds ends(true);
  runTests({program.executable.string(), "tests"}, isInstrumented, [&](const TestProcess& process) {
    if (process.result.timedOut) {
      throw std::runtime_error(fmt::format(
          "the tests did not end within {} s, nor took the processor time: the machine is too busy, or they "
          "wait for something; try again",
          wallSeconds));
    }
    for (const auto& [kind, text] : process.lines) reader.take(kind, text);
    reader.close(process.result);
    ends.take(process);
    report.output += process.result.out.substr(0, outputLimit - std::min(outputLimit, report.output.size()));
  });
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

CurvesReport drawCurves(const StudentProgram& program, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  const CommandResult result =
      runStudentProgram({program.executable.string(), "demo", folder.string()}, isInstrumented);
  CurvesReport curves;
  bool done = false;
  for (const auto& [kind, text] : readReport(result.report)) {
    if (kind == "figure") curves.figures.push_back(folder / text);
    if (kind == "crash") curves.trouble = printableText(text);
    if (kind == "done") done = true;
  }
  if (result.timedOut) curves.trouble = fmt::format("the demo did not end within {} s", wallSeconds);
  if (!done && curves.trouble.empty()) curves.trouble = "the demo ended early";
  return curves;
}

std::string countTests(const TestReport& report) {
  if (report.total == 0) return "no public test ran";
  const std::string left =
      report.notRun == 0 ? "" : fmt::format("; {} {} not run", report.notRun, report.notRun == 1 ? "was" : "were");
  return fmt::format("{} of {} public tests pass{}", report.passed, report.total, left);
}

std::string showFailure(const FailedTest& failure) {
  std::string text;
  if (!failure.property.empty()) text += fmt::format("  {}\n", failure.property);
  if (!failure.call.empty()) text += fmt::format("    {};\n", failure.call);
  // The first message is enough to mend; a test with ten components would hide the rest.
  constexpr std::size_t most = 2;
  std::size_t shown = 0;
  for (Mismatch mismatch : failure.mismatches) {
    if (shown++ == most) break;
    // "springForce(xa, xb, k, L0)": the call above says it with numbers.
    if (mismatch.ofCall && !failure.call.empty()) mismatch.expression.clear();
    text += indented(sentence(mismatch) + "\n", "    ");
  }
  for (const std::string& message : failure.messages) {
    if (shown++ >= most) break;
    text += indented(cutText(message, 12, 2000) + "\n", "    ");
  }
  return printableText(text);
}

}  // namespace muelle
