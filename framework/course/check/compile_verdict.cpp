#include "course/check/compile_verdict.h"

#include "base/text/printable.h"
#include "base/text/words.h"
#include "course/check/missing_functions.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <csignal>
#include <initializer_list>

namespace muelle {

namespace {

bool hasAny(std::string_view text, std::initializer_list<std::string_view> parts) {
  return std::ranges::any_of(parts, [&](std::string_view part) { return text.find(part) != std::string_view::npos; });
}

/// Complaints about the machine, which the compiler places wherever it happens to read, in the student's last line too.
bool isOfTheMachine(std::string_view message) {
  return hasAny(message, {"error writing to", "No space left on device", "Disk quota exceeded", "Input/output error",
                          "Too many open files", "Cannot allocate memory", "Read-only file system", "Permission denied",
                          "PCH file", "internal compiler error", "cannot execute"});
}

/// The driver's word for a process of the compiler that a signal has ended.
bool saysItWasKilled(std::string_view words) {
  return hasAny(words, {"signal terminated program", "unable to execute command", "internal compiler error",
                        "died unexpectedly"});
}

/// "g++: fatal error: CPU time limit exceeded signal terminated program cc1plus".
bool passedProcessorTime(const ToolRun& run, const CompileLimits& limits) {
  return run.signal == SIGXCPU || hasAny(run.words, {"CPU time limit exceeded", "Cputime limit exceeded"}) ||
         run.processorSeconds > static_cast<double>(limits.processorTime.count());
}

bool ranOutOfMemory(std::string_view words) {
  return hasAny(words, {"out of memory allocating", "virtual memory exhausted", "std::bad_alloc", "memory exhausted",
                        "Cannot allocate memory", "LLVM ERROR: out of memory"});
}

bool passedFileSize(const ToolRun& run) {
  return run.signal == SIGXFSZ || hasAny(run.words, {"File size limit exceeded", "File too large"});
}

bool wasEndedFromOutside(const ToolRun& run) {
  return run.endedFromOutside || (run.signal != 0 && isFromOutside(run.signal));
}

/// The first lines of what a tool said.
std::string excerpt(std::string_view words) { return printableText(cutText(words, 10, 2000)); }

/// A step that failed without a word about the student: what it is if the probe builds.
CompileVerdict undecided(const ToolRun& run, const CompileLimits& limits, std::string_view step, Outcome otherwise) {
  CompileVerdict verdict;
  verdict.isDecided = false;
  verdict.diagnostics = excerpt(run.words);
  if (run.timedOut) {
    verdict.outcome = Outcome::Wall;
    verdict.wasKilled = true;
    verdict.message = fmt::format("{} did not end within {} s: the machine is too busy", step, limits.wall.count());
  } else if (passedProcessorTime(run, limits)) {
    verdict.outcome = Outcome::Cpu;
    verdict.message = fmt::format("{} took more than {} s of processor time", step, limits.processorTime.count());
  } else if (wasEndedFromOutside(run)) {
    verdict.outcome = Outcome::Killed;
    verdict.wasKilled = true;
    verdict.endedFromOutside = true;
    verdict.message = fmt::format("{} was ended from outside", step);
  } else if (passedFileSize(run)) {
    verdict.outcome = Outcome::Compile;
    verdict.message = fmt::format("the compiled file is larger than {} MiB", limits.product >> 20U);
    verdict.diagnostics.clear();  // the compiler calls it an error of its own, to be reported
  } else if (ranOutOfMemory(run.words)) {
    verdict.outcome = Outcome::Compile;
    verdict.message = fmt::format("{} took more than {} MiB of memory", step, limits.memory >> 20U);
  } else if (run.signal != 0 || saysItWasKilled(run.words)) {
    verdict.outcome = Outcome::Killed;
    verdict.wasKilled = true;
    verdict.message = fmt::format("{} was ended by a signal", step);
  } else {
    verdict.outcome = otherwise;
    verdict.message = otherwise == Outcome::Link ? "it compiles, but does not fit its contract" : "it does not compile";
  }
  return verdict;
}

bool hasWord(std::string_view text, std::string_view word) {
  for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
    const bool begins = at == 0 || !isNameCharacter(text[at - 1]);
    const bool ends = at + word.size() >= text.size() || !isNameCharacter(text[at + word.size()]);
    if (begins && ends) return true;
  }
  return false;
}

/// The linker's complaint is about something that the student or the contract has written.
bool namesTheirs(std::string_view words, const std::vector<StudentFile>& files, std::string_view contract) {
  return std::ranges::any_of(linkedNames(words), [&](const std::string& name) {
    return hasWord(contract, name) ||
           std::ranges::any_of(files, [&](const StudentFile& file) { return hasWord(file.text, name); });
  });
}

}  // namespace

bool isFromOutside(int signal) {
  constexpr std::array ofItsOwn{SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTRAP, SIGSYS, SIGXCPU, SIGXFSZ};
  return std::ranges::find(ofItsOwn, signal) == ofItsOwn.end();
}

CompileVerdict judgeCompilation(const ToolRun& run, const std::vector<StudentFile>& files,
                                const CompileLimits& limits) {
  const std::vector<Diagnostic> found = parseDiagnostics(run.words, files);
  CompileVerdict verdict;
  if (run.succeeded) {
    verdict.diagnostics = showDiagnostics(found, files);
    return verdict;
  }
  const auto error =
      std::ranges::find_if(found, [](const Diagnostic& d) { return d.isError && !isOfTheMachine(d.message); });
  // A limit beside errors is the limit's: what stands before it may be cut short.
  const bool atLimit = run.timedOut || run.signal != 0 || run.endedFromOutside || passedProcessorTime(run, limits);
  if (error == found.end() || atLimit) return undecided(run, limits, "compiling", Outcome::Compile);
  verdict.outcome = Outcome::Compile;
  verdict.message = fmt::format("it does not compile: {}:{}: {}", error->file, error->line, error->message);
  verdict.diagnostics = showDiagnostics(found, files);
  if (!run.wordsCut) verdict.hidden = staticFunctions(run.words, files);
  return verdict;
}

CompileVerdict judgeLink(const ToolRun& run, const std::vector<StudentFile>& files, std::string_view contract,
                         std::string_view contractName, const CompileLimits& limits) {
  if (run.succeeded) return {};
  CompileVerdict verdict = undecided(run, limits, "linking", Outcome::Link);
  if (run.timedOut || run.signal != 0 || run.endedFromOutside || !namesTheirs(run.words, files, contract))
    return verdict;
  verdict.outcome = Outcome::Link;
  verdict.isDecided = true;
  verdict.wasKilled = false;
  verdict.message = "it compiles, but does not fit its contract";
  verdict.diagnostics = explainLinkErrors(run.words, files, contract, contractName);
  if (!run.wordsCut) verdict.missing = missingFunctions(run.words, contract);
  return verdict;
}

CompileVerdict afterProbe(CompileVerdict verdict, bool probeBuilds) {
  if (verdict.isDecided) return verdict;
  verdict.isDecided = true;
  verdict.isOurs = !probeBuilds || verdict.outcome == Outcome::Wall || verdict.endedFromOutside;
  if (!probeBuilds) {
    verdict.message = fmt::format("the compiler fails on a file that is known to be good, too ({})", verdict.message);
  }
  return verdict;
}

}  // namespace muelle
