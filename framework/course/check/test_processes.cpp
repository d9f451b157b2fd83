#include "course/check/test_processes.h"

#include "course/check/compile_rules.h"
#include "course/check/crash_report.h"
#include "course/check/fault_sentences.h"
#include "course/check/outcome.h"
#include "course/check/report_line.h"

#include <algorithm>
#include <chrono>
#include <csignal>

namespace muelle {

namespace {

constexpr std::size_t testsMemory = 1UL << 30U;  ///< [bytes] as the grader's

}  // namespace

CommandResult runStudentProgram(const std::vector<std::string>& command, Instrumented instrumented, int callSeconds) {
  ChildSpec spec;
  spec.command = command;
  spec.inheritsEnvironment = true;
  spec.environment = {
      "LC_ALL=C",
      callSecondsVariable + std::string("=") + std::to_string(callSeconds),
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
  if (instrumented == Instrumented::No) spec.limits.addressSpace = testsMemory;
#endif
  const unsigned factor = instrumented == Instrumented::Yes ? sanitizedFactor : 1;
  spec.limits.cpuSeconds = factor * testsProcessorSeconds(callSeconds);
  // An endless recursion must meet the end of the stack before the end of the memory.
  spec.limits.stack = (instrumented == Instrumented::Yes ? sanitizedStackFactor : 1) * (std::size_t{8} << 20U);
  return runCommand(
      spec, {factor * std::chrono::seconds(testsWallSeconds), studentOutputLimit, 0, 16 * studentOutputLimit, true});
}

bool isOwnSignal(int signal) { return signalSentence(signal) != nullptr || signal == SIGSYS; }

std::string TestProcess::begun() const {
  std::string names;
  for (const auto& [kind, text] : lines) {
    if (kind == "test") names += (names.empty() ? "" : ":") + text;
  }
  return names;
}

bool TestProcess::leavesTests() const {
  long left = 0;
  bool done = result.timedOut;
  for (const auto& [kind, text] : lines) {
    if (kind == "planned") ++left;
    if (kind == "test") --left;
    if (kind == "done") done = true;
  }
  return !done && left > 0;
}

bool isMachines(const TestProcess& process) {
  const ExitStatus& status = process.result.status;
  if (process.result.timedOut || (status.signalled && !isOwnSignal(status.code))) return true;
  return std::ranges::find(process.lines, std::pair<std::string, std::string>("outcome", nameOf(Outcome::Struck))) !=
         process.lines.end();
}

void runTests(const std::vector<std::string>& command, Instrumented instrumented, int callSeconds,
              const std::function<void(const TestProcess&)>& take) {
  const double enough = allCallsSeconds(callSeconds);  // [s] of processor time
  constexpr auto enoughWall = std::chrono::seconds(20);
  const auto start = std::chrono::steady_clock::now();
  std::string begun;
  double used = 0.0;
  for (bool goesOn = true; goesOn;) {
    std::vector<std::string> words = command;
    if (!begun.empty()) words.push_back("--gtest_filter=-" + begun);
    const auto run = [&] {
      CommandResult result = runStudentProgram(words, instrumented, callSeconds);
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

}  // namespace muelle
