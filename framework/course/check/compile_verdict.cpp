#include "course/check/compile_verdict.h"

#include <fmt/format.h>

namespace muelle {

CompileVerdict judgeCompilation(const CompileRun& run, const std::vector<StudentFile>& files, std::string_view contract,
                                std::string_view contractName, const CompileLimits& limits,
                                std::size_t largestProduct) {
  CompileVerdict verdict;
  const CommandResult& result = run.result;
  if (result.timedOut) {
    verdict.message = "compiling did not end";
    verdict.isMachines = true;
    return verdict;
  }
  if (result.status.cpuSeconds >= limits.cpuSeconds) {
    verdict.message = fmt::format("compiling took more than {} s of processor time", limits.cpuSeconds);
    verdict.isCertain = true;
    return verdict;
  }
  if (run.failed == CompileRun::Stage::None) {
    verdict.isCertain = true;
    if (result.outCut) {
      verdict.message = fmt::format("the compiled file is larger than {} MiB", largestProduct >> 20U);
      return verdict;
    }
    verdict.outcome = Outcome::Passed;
    return verdict;
  }
  if (run.failed == CompileRun::Stage::Compiling) {
    const std::vector<Diagnostic> diagnostics = parseDiagnostics(result.err, files);
    verdict.diagnostics = cutDiagnostics(result.err, files);
    verdict.message = "it does not compile";
    if (diagnostics.empty() || !diagnostics.front().isError) return verdict;
    const Diagnostic& first = diagnostics.front();
    verdict.message = fmt::format("it does not compile: {}:{}: {}", first.file, first.line, first.message);
    verdict.isCertain = true;
    return verdict;
  }
  if (run.failed == CompileRun::Stage::Linking) {
    verdict.outcome = Outcome::Link;
    verdict.message = "it compiles, but does not fit its contract";
    verdict.diagnostics = explainLinkErrors(result.err, files, contract, contractName);
    verdict.isCertain = result.err.find("undefined") != std::string::npos;
    return verdict;
  }
  verdict.message = "the compiler died";
  return verdict;
}

std::string probeSource(const std::vector<StudentFile>&, std::string_view contractName) {
  return fmt::format("#include \"{}\"\n", contractName);
}

}  // namespace muelle
