#include "grader/run/build_worker.h"

#include "base/file.h"
#include "course/check/compile_verdict.h"
#include "course/check/missing_functions.h"
#include "course/check/probe.h"
#include "course/check/second_look.h"
#include "course/check/symbols.h"
#include "grader/run/compile.h"
#include "grader/run/digest.h"
#include "grader/run/replaced_object.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace muelle::grader {

namespace {

namespace fs = std::filesystem;
using Status = BuildOutcome::Status;

constexpr const char* outcomeSuffix = ".build";
constexpr const char* objectSuffix = ".so";
constexpr const char* sanitisedSuffix = ".asan.so";
constexpr const char* refilledSuffix = ".refilled.so";

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
        built_(sources),
        sandbox_(sandbox),
        key_(objectKey(workplace, manifest, sources, sandbox.choice())),
        fresh_(options.fresh) {}

  BuildAttempt build(bool isLastTry) {
    if (!fresh_) {
      if (const auto kept = this->kept()) return {*kept, false, false};
    }
    Compilation compilation = compile(workplace_, manifest_, sources_, sandbox_);
    CompileVerdict verdict = verdictOn(compilation);
    if (!verdict.hidden.empty()) {
      hidden_ = verdict.hidden;
      compilation = compileOnceMore();
      verdict = verdictOn(compilation);
    }
    if (!verdict.missing.empty()) {
      const CompileVerdict without = verdict;
      addMissing(verdict.missing);
      compilation = compileOnceMore();
      verdict = verdictOn(compilation);
      if (!verdict.passed()) verdict = without;
      verdict.diagnostics = without.diagnostics;
    }
    if (verdict.passed()) return {keep(compilation, verdict), false, true};
    if (verdict.isDecided) return {refuse(verdict), false, true};
    if (!isLastTry) return {ours(verdict.message), true, true};
    // The machine's fault, unless a known good file compiles where this one has failed twice by itself.
    const CompileVerdict final = afterProbe(verdict, verdict.endedFromOutside || probeBuilds());
    return {final.isOurs ? ours(final.message) : refuse(final), false, true};
  }

 private:
  /// A definition of each function that is missing: a call of one says so.
  void addMissing(const std::vector<std::string>& functions) {
    const fs::path contract = workplace_.contract(manifest_.topic);
    built_[missingSourceName] =
        missingSource(functions, studentFiles(sources_), readFile(contract), contract.filename().string());
  }

  Compilation compileOnceMore() const {
    return compile(workplace_, manifest_, built_, sandbox_, Build::Plain, hidden_);
  }

  static ToolRun toolRun(const Compilation& compilation, bool succeeded) {
    constexpr int signalled = 128;  // a shell and bubblewrap pass a signal on as 128 + signal
    const CommandResult& result = compilation.run;
    ToolRun run;
    run.words = result.err;
    run.succeeded = succeeded;
    run.timedOut = result.timedOut;
    run.endedFromOutside = !succeeded && compilation.endedFromOutside;
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
    CompileVerdict verdict = judgeCompilation(toolRun(compilation, compiled), files, workplace_.limits);
    if (!compiled) return verdict;
    const CompileVerdict read = judgeDependencies(compilation.dependencies, placeInSandbox(), studentFiles(built_));
    if (workplace_.judgesSymbols && !read.passed()) return read;
    const SymbolVerdict symbols = judgeSymbols(readSymbols(compilation.symbols));
    if (workplace_.judgesSymbols && symbols.outcome != Outcome::Passed) {
      verdict.outcome = symbols.outcome;
      verdict.message = symbols.message;
      return verdict;
    }
    const fs::path contract = workplace_.contract(manifest_.topic);
    if (compilation.stage == Stage::Linking) {
      return judgeLink(toolRun(compilation, false), files, readFile(contract), contract.filename().string(),
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

  /// nullopt for what is not as it was written, too: then it is built again.
  std::optional<BuiltObject> kept() const {
    const auto text = store_.read(key_, outcomeSuffix);
    if (!text) return std::nullopt;
    try {
      const nlohmann::json document = nlohmann::json::parse(*text);
      BuiltObject object;
      object.outcome.status = static_cast<Status>(document.at("status").get<int>());
      object.outcome.outcome = outcomeNamed(document.at("outcome").get<std::string>());
      document.at("message").get_to(object.outcome.message);
      document.at("diagnostics").get_to(object.outcome.diagnostics);
      if (object.outcome.status != Status::Built) return object;
      object.plain = whole(objectSuffix, document.at("plain").get<std::string>());
      const std::string sanitised = document.at("sanitised");
      if (!sanitised.empty()) object.sanitised = whole(sanitisedSuffix, sanitised);
      const std::string refilled = document.at("refilled");
      if (!refilled.empty()) object.refilled = whole(refilledSuffix, refilled);
      return object;
    } catch (const std::exception&) {
      return std::nullopt;
    }
  }

  /// A kept object. Throws std::runtime_error when its content is another than the one that was kept.
  fs::path whole(const char* suffix, const std::string& expected) const {
    fs::path file = store_.file(key_, suffix);
    if (digestOfFile(file) + digestOfFile(partsOf(file)) != expected)
      throw std::runtime_error("damaged: " + file.string());
    return file;
  }

  /// The digests of the objects and their parts; "" where there is none.
  struct Digests {
    std::string plain, sanitised, refilled;
  };

  void write(const BuildOutcome& outcome, const Digests& digests = {}) const {
    const nlohmann::json document{{"status", static_cast<int>(outcome.status)},
                                  {"outcome", std::string(nameOf(outcome.outcome))},
                                  {"message", outcome.message},
                                  {"diagnostics", outcome.diagnostics},
                                  {"plain", digests.plain},
                                  {"sanitised", digests.sanitised},
                                  {"refilled", digests.refilled}};
    store_.write(key_, outcomeSuffix, document.dump(1, ' ', false, nlohmann::json::error_handler_t::replace));
  }

  /// Puts an object and its parts into the store; their digests.
  std::string store(const char* suffix, const Compilation& compilation) const {
    store_.write(key_, suffix, compilation.run.out);
    store_.write(key_, partsOf(suffix).string(), compilation.parts);
    return digestOfBytes(compilation.run.out) + digestOfBytes(compilation.parts);
  }

  /// The objects first: whoever reads the outcome finds them.
  BuiltObject keep(const Compilation& compilation, const CompileVerdict& verdict) const {
    BuiltObject object;
    object.outcome = {Status::Built, "", verdict.diagnostics, Outcome::Passed};
    Digests digests;
    digests.plain = store(objectSuffix, compilation);
    object.plain = store_.file(key_, objectSuffix);
    const ToolRun run = toolRun(compilation, true);
    const std::vector<StudentFile> files = studentFiles(sources_);
    if (wantsSecondLook(run, files)) digests.sanitised = addSanitised(object);
    if (wantsOtherFill(run, files)) digests.refilled = addRefilled(object);
    write(object.outcome, digests);
    return object;
  }

  /// What the plain build was good for stays, whatever becomes of this one: its failure is nobody's fault.
  /// \return the digest of the kept object; "" where there is none
  std::string addSanitised(BuiltObject& object) const {
    const Compilation second = compileAgain(Build::Sanitised);
    if (second.stage != Compilation::Stage::Done) {
      object.outcome.diagnostics += sayNoSecondLook(toolRun(second, false), studentFiles(sources_));
      return "";
    }
    object.sanitised = store_.file(key_, sanitisedSuffix);
    return store(sanitisedSuffix, second);
  }

  /// The same; a file that does without the first fill does without this one, unless the machine is in the way.
  std::string addRefilled(BuiltObject& object) const {
    const Compilation second = compileAgain(Build::Refilled);
    if (second.stage != Compilation::Stage::Done) return "";
    object.refilled = store_.file(key_, refilledSuffix);
    return store(refilledSuffix, second);
  }

  Compilation compileAgain(Build build) const {
    Compilation second = compile(workplace_, manifest_, built_, sandbox_, build, hidden_);
    const bool isMachines = second.stage == Compilation::Stage::Elsewhere || second.endedFromOutside;
    return isMachines ? compile(workplace_, manifest_, built_, sandbox_, build, hidden_) : second;
  }

  BuiltObject refuse(const CompileVerdict& verdict) const {
    BuiltObject object;
    object.outcome = {Status::CompileError, verdict.message, verdict.diagnostics, verdict.outcome};
    write(object.outcome);
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
  Sources built_;                    ///< with what stands for functions that are missing
  std::vector<std::string> hidden_;  ///< functions of the contract that the file makes static
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
