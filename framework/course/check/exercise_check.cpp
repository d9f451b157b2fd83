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
#include <stdexcept>

namespace muelle {

namespace {

/// Wide: the program counts its own processor time, and ends itself long before on a machine that lets it work.
constexpr int wallSeconds = 60;
constexpr unsigned processorSeconds = 15;

constexpr std::size_t memory = 1UL << 30U;  ///< [bytes] as the grader's

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
      "ASAN_OPTIONS=detect_leaks=0:detect_stack_use_after_return=1:detect_container_overflow=0:handle_segv=0:"
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
  constexpr std::size_t bytes = 65536;
  return runCommand(spec, {factor * std::chrono::seconds(wallSeconds), bytes, 0, 16 * bytes, true});
}

/// Of the plain build: Yes in a build folder that has sanitizers everywhere.
#if defined(__SANITIZE_ADDRESS__)
constexpr Instrumented isInstrumented = Instrumented::Yes;
#else
constexpr Instrumented isInstrumented = Instrumented::No;
#endif

/// Builds the report from what the program wrote.
class ReportReader {
 public:
  explicit ReportReader(TestReport& report) : report_(report) {}

  void take(const std::string& kind, const std::string& text) {
    if (kind == "tests") report_.total = std::atoi(text.c_str());
    if (kind == "test") begin(text);
    if (kind == "call" && current_.call.empty()) current_.call = text;
    if (kind == "mismatch") takeMismatch(text);
    if (kind == "failure") current_.messages.push_back(text);
    if (kind == "property") current_.property = text;
    if (kind == "outcome" && !hasOutcome_) {
      current_.outcome = outcomeNamed(text);
      hasOutcome_ = true;
    }
    if (kind == "factor") takeFactor(text);
    if (kind == "crash") report_.crash = text;
    if (kind == "end") end(text == "passed");
    if (kind == "done") done_ = true;
  }

  /// A test that began and did not end is the one that crashed.
  void close(const CommandResult& result) {
    if (!done_ && report_.crash.empty()) {
      report_.crash = describe(result);
      current_.outcome = outcomeOf(result);
    }
    explainAbort(result.out);
    if (running_) {
      current_.messages.push_back(report_.crash);
      report_.failures.push_back(current_);
    } else if (!done_) {
      lastOutcome_ = current_.outcome;
    }
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
    const std::string damage = report_.crash.ends_with(plain) ? heapDamage(output) : "";
    if (!damage.empty()) report_.crash.replace(report_.crash.size() - plain.size(), plain.size(), damage);
  }

  void takeMismatch(const std::string& text) {
    if (const std::optional<Mismatch> mismatch = readMismatch(text)) current_.mismatches.push_back(*mismatch);
  }
  /// "-1 springForce"
  void takeFactor(const std::string& text) {
    const std::size_t blank = std::min(text.find(' '), text.size());
    const std::optional<double> factor = exactNumber(text.substr(0, blank));
    if (factor && blank < text.size()) report_.findings.push_back({text.substr(blank + 1), *factor});
  }
  void begin(const std::string& fullName) {
    const std::size_t dot = fullName.find('.');
    current_ = FailedTest{};
    hasOutcome_ = false;
    current_.suite = fullName.substr(0, dot);
    current_.name = fullName.substr(dot + 1);
    running_ = true;
  }
  void end(bool passed) {
    running_ = false;
    hasOutcome_ = false;
    if (passed) {
      ++report_.passed;
    } else {
      report_.failures.push_back(current_);
    }
  }
  std::string describe(const CommandResult& result) const {
    const std::string who = report_.total == 0 ? loadingCode : "your code";
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
    return result.status.code == SIGKILL ? Outcome::Killed : Outcome::Crash;
  }

  TestReport& report_;
  FailedTest current_;
  bool running_ = false;
  bool done_ = false;
  bool hasOutcome_ = false;  ///< of the test that runs
  Outcome lastOutcome_ = Outcome::Crash;
};

/// What the sanitizers find in the second build. How it ends otherwise says nothing: everything is dearer there.
SanitizerFinding secondLook(const StudentProgram& program) {
  if (program.sanitized.empty()) return {};
  const CommandResult result = runStudentProgram({program.sanitized.string(), "tests", "slowly"}, Instrumented::Yes);
  return explainSanitizers(result.out, program.students);
}

/// Puts what the second look has confirmed before everything else.
void addConfirmed(const SanitizerFinding& finding, TestReport& report) {
  if (finding.sentence.empty()) return;
  if (report.failures.empty()) {
    FailedTest failure;
    failure.name = "memory";
    report.failures.push_back(failure);
    report.passed = 0;
  }
  FailedTest& first = report.failures.front();
  first.messages.insert(first.messages.begin(), finding.sentence);
  first.outcome = finding.outcome;
}

}  // namespace

Outcome checkOutcome(const StudentProgram& program, const TestReport& report) {
  return program.outcome == Outcome::Passed ? report.outcome : program.outcome;
}

TestReport runPublicTests(const StudentProgram& program) {
  const std::vector<std::string> command{program.executable.string(), "tests"};
  CommandResult result = runStudentProgram(command, isInstrumented);
  // From outside, perhaps, or stopped: once more.
  const auto isMachines = [](const CommandResult& r) {
    return r.timedOut || (r.status.signalled && r.status.code == SIGKILL);
  };
  if (isMachines(result)) result = runStudentProgram(command, isInstrumented);
  if (result.timedOut) {
    throw std::runtime_error(
        fmt::format("the tests did not end within {} s, nor took the processor time: the machine is too busy, or they "
                    "wait for something; try again",
                    wallSeconds));
  }
  TestReport report;
  ReportReader reader(report);
  for (const auto& [kind, text] : readReport(result.report)) reader.take(kind, text);
  reader.close(result);
  report.output = result.out;
  addConfirmed(secondLook(program), report);
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
