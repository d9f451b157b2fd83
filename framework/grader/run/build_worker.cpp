#include "grader/run/build_worker.h"

#include "base/file.h"
#include "course/check/compile_verdict.h"
#include "course/check/probe.h"
#include "course/check/second_look.h"
#include "course/check/symbols.h"
#include "grader/run/compile.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace muelle::grader {

namespace {

namespace fs = std::filesystem;
using Status = BuildOutcome::Status;

constexpr const char* outcomeSuffix = ".build";
constexpr const char* objectSuffix = ".so";
constexpr const char* sanitisedSuffix = ".asan.so";

std::vector<StudentFile> studentFiles(const Sources& sources) {
  std::vector<StudentFile> files;
  for (const auto& [name, content] : sources) files.push_back({name, content});
  return files;
}

/// One hand-in on its way to a shared object.
class Builder {
 public:
  Builder(const Workplace& workplace, const Store& store, const Manifest& manifest, const Sources& sources,
          const Sandbox& sandbox, const GradeOptions& options)
      : workplace_(workplace),
        store_(store),
        manifest_(manifest),
        sources_(sources),
        sandbox_(sandbox),
        key_(objectKey(workplace, manifest, sources, sandbox.choice())),
        fresh_(options.fresh) {}

  BuildAttempt build(bool isLastTry) const {
    if (!fresh_) {
      if (const auto kept = this->kept()) return {*kept, false, false};
    }
    const Compilation compilation = compile(workplace_, manifest_, sources_, sandbox_);
    const CompileVerdict verdict = verdictOn(compilation);
    if (verdict.passed()) return {keep(compilation, verdict), false, true};
    if (verdict.isDecided) return {refuse(verdict), false, true};
    if (!isLastTry) return {ours(verdict.message), true, true};
    // The machine's fault, unless a known good file compiles where this one has failed twice.
    const CompileVerdict final = afterProbe(verdict, probeBuilds());
    return {final.isOurs ? ours(final.message) : refuse(final), false, true};
  }

 private:
  static ToolRun toolRun(const CommandResult& result, bool succeeded) {
    constexpr int signalled = 128;  // a shell and bubblewrap pass a signal on as 128 + signal
    ToolRun run;
    run.words = result.err;
    run.succeeded = succeeded;
    run.timedOut = result.timedOut;
    run.processorSeconds = result.status.cpuSeconds;
    run.wordsCut = result.errCut;
    if (result.status.signalled) run.signal = result.status.code;
    if (!result.status.signalled && result.status.code > signalled) run.signal = result.status.code - signalled;
    return run;
  }

  /// The compiler's word, then that of the symbols, then the linker's.
  CompileVerdict verdictOn(const Compilation& compilation) const {
    using Stage = Compilation::Stage;
    const std::vector<StudentFile> files = studentFiles(sources_);
    const bool compiled = compilation.stage == Stage::Linking || compilation.stage == Stage::Done;
    CompileVerdict verdict = judgeCompilation(toolRun(compilation.run, compiled), files, workplace_.limits);
    if (!compiled) return verdict;
    const SymbolVerdict symbols = judgeSymbols(readSymbols(compilation.symbols));
    if (workplace_.judgesSymbols && symbols.outcome != Outcome::Passed) {
      verdict.outcome = symbols.outcome;
      verdict.message = symbols.message;
      return verdict;
    }
    const fs::path contract = workplace_.contract(manifest_.topic);
    if (compilation.stage == Stage::Linking) {
      return judgeLink(toolRun(compilation.run, false), files, readFile(contract), contract.filename().string(),
                       workplace_.limits);
    }
    if (compilation.run.outCut) {
      verdict.outcome = Outcome::Compile;
      verdict.message = fmt::format("the compiled file is larger than {} MiB", workplace_.limits.product >> 20U);
    }
    return verdict;
  }

  bool probeBuilds() const {
    const Sources probe{{manifest_.files.front(), probeSource(studentFiles(sources_), manifest_.topic + ".h")}};
    return compile(workplace_, manifest_, probe, sandbox_, Build::Probe).stage == Compilation::Stage::Done;
  }

  std::optional<BuiltObject> kept() const {
    const auto text = store_.read(key_, outcomeSuffix);
    if (!text) return std::nullopt;
    const nlohmann::json document = nlohmann::json::parse(*text, nullptr, false);
    if (!document.is_object() || !document.contains("status") || !document.contains("sanitised")) return std::nullopt;
    BuiltObject object;
    object.outcome.status = static_cast<Status>(document["status"].get<int>());
    object.outcome.outcome = outcomeNamed(document["outcome"].get<std::string>());
    object.outcome.message = document["message"].get<std::string>();
    object.outcome.diagnostics = document["diagnostics"].get<std::string>();
    object.plain = store_.file(key_, objectSuffix);
    if (document["sanitised"].get<bool>()) object.sanitised = store_.file(key_, sanitisedSuffix);
    const bool isWhole =
        object.outcome.status != Status::Built ||
        (store_.has(key_, objectSuffix) && (object.sanitised.empty() || store_.has(key_, sanitisedSuffix)));
    return isWhole ? std::optional(object) : std::nullopt;
  }

  void write(const BuiltObject& object) const {
    const nlohmann::json document{{"status", static_cast<int>(object.outcome.status)},
                                  {"outcome", std::string(nameOf(object.outcome.outcome))},
                                  {"message", object.outcome.message},
                                  {"diagnostics", object.outcome.diagnostics},
                                  {"sanitised", !object.sanitised.empty()}};
    store_.write(key_, outcomeSuffix, document.dump(1, ' ', false, nlohmann::json::error_handler_t::replace));
  }

  /// The objects first: whoever reads the outcome finds them.
  BuiltObject keep(const Compilation& compilation, const CompileVerdict& verdict) const {
    BuiltObject object;
    object.outcome = {Status::Built, "", verdict.diagnostics, Outcome::Passed};
    store_.write(key_, objectSuffix, compilation.run.out);
    object.plain = store_.file(key_, objectSuffix);
    if (wantsSecondLook(toolRun(compilation.run, true), studentFiles(sources_))) addSanitised(object);
    write(object);
    return object;
  }

  /// What the plain build was good for stays, whatever becomes of this one: its failure is nobody's fault.
  void addSanitised(BuiltObject& object) const {
    Compilation second = compile(workplace_, manifest_, sources_, sandbox_, Build::Sanitised);
    if (second.stage == Compilation::Stage::Elsewhere) {  // killed, perhaps by the machine
      second = compile(workplace_, manifest_, sources_, sandbox_, Build::Sanitised);
    }
    if (second.stage == Compilation::Stage::Done) {
      store_.write(key_, sanitisedSuffix, second.run.out);
      object.sanitised = store_.file(key_, sanitisedSuffix);
    } else {
      object.outcome.diagnostics += sayNoSecondLook(toolRun(second.run, false), studentFiles(sources_));
    }
  }

  BuiltObject refuse(const CompileVerdict& verdict) const {
    BuiltObject object;
    object.outcome = {Status::CompileError, verdict.message, verdict.diagnostics, verdict.outcome};
    write(object);
    return object;
  }

  static BuiltObject ours(const std::string& what) {
    BuiltObject object;
    object.outcome = {Status::GraderFault, what, "", Outcome::Killed};
    return object;
  }

  const Workplace& workplace_;
  const Store& store_;
  const Manifest& manifest_;
  const Sources& sources_;
  const Sandbox& sandbox_;
  const std::string key_;
  const bool fresh_;
};

}  // namespace

BuildAttempt buildObject(const Workplace& workplace, const Store& store, const Manifest& manifest,
                         const Sources& sources, const Sandbox& sandbox, const GradeOptions& options, bool isLastTry) {
  return Builder(workplace, store, manifest, sources, sandbox, options).build(isLastTry);
}

}  // namespace muelle::grader
