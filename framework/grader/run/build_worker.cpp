#include "grader/run/build_worker.h"

#include "base/build_paths.h"
#include "base/file.h"
#include "course/check/diagnostics.h"
#include "grader/record.h"
#include "grader/run/digest.h"
#include "grader/run/shared_prelude.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <nlohmann/json.hpp>

namespace muelle::grader {

namespace {

namespace fs = std::filesystem;

/// The compiler's own limits, so that a template or constexpr bomb ends early with words instead of by force.
constexpr const char* compilerLimits = "-w -fmax-errors=20 -ftemplate-depth=400 -fconstexpr-ops-limit=10000000";
constexpr const char* linkFlags = "-shared -Wl,-Bsymbolic,-z,defs,-z,now,-z,noexecstack,--build-id=none";

/// Exit statuses of the script below: which of its commands failed.
constexpr int compileFailed = 10;
constexpr int linkFailed = 11;

/// Runs inside the sandbox, in its root folder, which only some backends can make "/". Nothing of the student's runs
/// here, only the compiler does; the product leaves by stdout.
std::string script(const std::vector<std::string>& names) {
  std::string files;
  for (const std::string& name : names) files += " ../submission/" + name;
  return fmt::format(
      "cd tmp && {0} {1} {2} {7} -I../prelude -include prelude.h -I../contract -I../framework -isystem ../eigen -c{3} "
      "|| exit {4}\n{0} {5} *.o -Wl,--whole-archive ../glue.a -Wl,--no-whole-archive -o submission.so || exit {6}\ncat "
      "submission.so\n",
      fs::canonical(build_paths::compiler).string(), build_paths::studentFlags, compilerLimits, files, compileFailed,
      linkFlags, linkFailed, fmt::join(diagnosticFlags(), " "));
}

/// Every header of the harness's top folder: what a contract and a student may include.
void addHarnessHeaders(const Workplace& workplace, std::vector<VisibleFile>& files) {
  for (const auto& entry : fs::directory_iterator(workplace.harness())) {
    if (entry.path().extension() == ".h") {
      files.push_back({"/framework/harness/" + entry.path().filename().string(), entry.path(), "", false});
    }
  }
  std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) { return a.inside < b.inside; });
}

std::vector<std::string> namesOf(const Sources& sources) {
  std::vector<std::string> names;
  for (const auto& [name, content] : sources) names.push_back(name);
  return names;
}

/// The precompiled header is large: it is mounted, and handed over as content only when that cannot be.
void addPrelude(const Workplace& workplace, Confinement& confinement) {
  if (const auto folder = sharedPrelude(workplace)) {
    confinement.renamedFolders[folder->string()] = "/prelude";
  } else {
    confinement.files.push_back({"/prelude/prelude.h.gch", workplace.prelude(), "", false});
  }
}

Confinement compilation(const Workplace& workplace, const Manifest& manifest, const Sources& sources,
                        const CompileLimits& limits) {
  Confinement confinement;
  for (const auto& [name, content] : sources) {
    confinement.files.push_back({"/submission/" + name, {}, content, false});
  }
  confinement.files.push_back({"/contract/" + manifest.topic + ".h", workplace.contract(manifest.topic), "", false});
  confinement.files.push_back({"/glue.a", workplace.glue(manifest.topic), "", false});
  addPrelude(workplace, confinement);
  addHarnessHeaders(workplace, confinement.files);
  confinement.command = {"/usr/bin/sh", "-c", script(namesOf(sources))};
  confinement.systemFolders = {"/usr/bin", "/usr/lib", "/usr/include"};
  if (fs::exists("/usr/lib64")) confinement.systemFolders.emplace_back("/usr/lib64");
  confinement.renamedFolders[build_paths::eigen] = "/eigen";
  confinement.scratchBytes = limits.scratch;
  confinement.limits.addressSpace = limits.memory;
  confinement.limits.fileSize = limits.scratch;
  confinement.limits.cpuSeconds = static_cast<unsigned>(limits.time.count()) + 1;
  return confinement;
}

std::vector<StudentFile> studentFiles(const Sources& sources) {
  std::vector<StudentFile> files;
  for (const auto& [name, content] : sources) files.push_back({name, content});
  return files;
}

/// The compiler's complaints, cut to the student's own lines.
BuildOutcome explainCompiler(const std::string& words, const Sources& sources) {
  const std::vector<StudentFile> files = studentFiles(sources);
  const std::vector<Diagnostic> diagnostics = parseDiagnostics(words, files);
  BuildOutcome outcome{BuildOutcome::Status::CompileError, "it does not compile", cutDiagnostics(words, files)};
  if (diagnostics.empty()) return outcome;
  const Diagnostic& first = diagnostics.front();
  outcome.message = fmt::format("it does not compile: {}:{}: {}", first.file, first.line, first.message);
  return outcome;
}

BuildOutcome explainLinker(const Workplace& workplace, const std::string& words, const Manifest& manifest,
                           const Sources& sources) {
  const fs::path contract = workplace.contract(manifest.topic);
  return {BuildOutcome::Status::CompileError, "it compiles, but does not fit its contract",
          explainLinkErrors(words, studentFiles(sources), readFile(contract), contract.filename().string())};
}

BuildOutcome judge(const Workplace& workplace, const CommandResult& result, const Manifest& manifest,
                   const Sources& sources, const CompileLimits& limits) {
  using Status = BuildOutcome::Status;
  if (result.timedOut) {
    return {Status::CompileError, fmt::format("compiling took longer than {} s", limits.time.count()), ""};
  }
  const bool ended = !result.status.signalled;
  if (ended && result.status.code == 0) {
    if (!result.outCut) return {Status::Built, "", ""};
    return {Status::CompileError, fmt::format("the compiled file is larger than {} MiB", limits.product >> 20), ""};
  }
  if (ended && result.status.code == compileFailed) return explainCompiler(result.err, sources);
  if (ended && result.status.code == linkFailed) return explainLinker(workplace, result.err, manifest, sources);
  if (!ended || result.status.code > 128) {
    return {Status::CompileError, "the compiler ran out of time, memory or space", result.err.substr(0, 2000)};
  }
  return {Status::GraderFault, "the compiler could not be run in the sandbox: " + result.err.substr(0, 500), ""};
}

nlohmann::json toJson(const BuildOutcome& outcome) {
  return {
      {"status", static_cast<int>(outcome.status)}, {"message", outcome.message}, {"diagnostics", outcome.diagnostics}};
}

/// A new compiler package rebuilds the workers.
std::string compilerVersion() { return fs::canonical(build_paths::compiler).string() + __VERSION__; }

}  // namespace

std::string workerKey(const Workplace& workplace, const Manifest& manifest, const Sources& sources) {
  std::string content;
  for (const auto& [name, text] : sources) content += digest({name, text});
  std::vector<VisibleFile> headers;
  addHarnessHeaders(workplace, headers);
  for (const VisibleFile& header : headers) content += digestOfFile(header.source);
  return digest({manifest.topic, content, readFile(workplace.contract(manifest.topic)),
                 digestOfFile(workplace.glue(manifest.topic)), script(namesOf(sources)), compilerVersion()});
}

fs::path workerFolder(const Workplace& workplace, const std::string& key) { return workplace.workers() / key; }

fs::path submissionObject(const Workplace& workplace, const std::string& key) {
  return workerFolder(workplace, key) / "submission.so";
}

std::optional<BuildOutcome> readBuildOutcome(const Workplace& workplace, const std::string& key) {
  const fs::path file = workerFolder(workplace, key) / "build.json";
  if (!fs::exists(file)) return std::nullopt;
  try {
    const nlohmann::json document = nlohmann::json::parse(readFile(file));
    BuildOutcome outcome;
    outcome.status = static_cast<BuildOutcome::Status>(document.at("status").get<int>());
    document.at("message").get_to(outcome.message);
    document.at("diagnostics").get_to(outcome.diagnostics);
    if (outcome.status == BuildOutcome::Status::Built && !fs::exists(submissionObject(workplace, key)))
      return std::nullopt;
    return outcome;
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  }
}

BuildOutcome buildWorker(const Workplace& workplace, const Manifest& manifest, const Sources& sources,
                         const Sandbox& sandbox, const CompileLimits& limits) {
  const std::string key = workerKey(workplace, manifest, sources);
  if (const auto earlier = readBuildOutcome(workplace, key);
      earlier && earlier->status != BuildOutcome::Status::GraderFault) {
    return *earlier;  // a fault of the grader's is tried again
  }
  BuildOutcome outcome;
  try {
    const CommandResult result =
        sandbox.run(compilation(workplace, manifest, sources, limits), limits.time, limits.product, limits.diagnostics);
    outcome = judge(workplace, result, manifest, sources, limits);
    fs::create_directories(workerFolder(workplace, key));
    if (outcome.status == BuildOutcome::Status::Built) writeFile(submissionObject(workplace, key), result.out);
  } catch (const std::exception& error) {
    outcome = {BuildOutcome::Status::GraderFault, error.what(), ""};
  }
  fs::create_directories(workerFolder(workplace, key));
  writeFile(workerFolder(workplace, key) / "build.json",
            toJson(outcome).dump(1, ' ', false, nlohmann::json::error_handler_t::replace));
  return outcome;
}

}  // namespace muelle::grader
