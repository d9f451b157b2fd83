#include "grader/run/compile.h"

#include "base/build_paths.h"
#include "course/check/compile_rules.h"
#include "course/check/dependencies.h"
#include "course/check/filled_flags.h"
#include "grader/run/digest.h"
#include "grader/run/shared_prelude.h"
#include "grader/run/tool_watch.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>

namespace muelle::grader {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t scratchBytes = 256UL * 1024 * 1024;
constexpr std::size_t symbolBytes = 1024 * 1024;

constexpr const char* linkFlags = "-shared -Wl,-Bsymbolic,-z,now,-z,noexecstack,--build-id=none";

/// Exit statuses of the script: which of its commands failed.
constexpr int compileFailed = 10;
constexpr int linkFailed = 11;
constexpr int symbolsFailed = 12;

/// Between what was read and the symbols.
constexpr const char* symbolsFollow = "-- symbols";

/// A compiler that the sandbox does not have under its own name is handed over as a file.
bool isOfTheSystem(const fs::path& program) { return program.string().starts_with("/usr/"); }
std::string insideOf(const fs::path& compiler) {
  return isOfTheSystem(compiler) ? compiler.string() : "../tools/" + compiler.filename().string();
}

/// mold sets the mode of what it has written, which the list of system calls that goes with Landlock refuses; the
/// compiler's own linker does without.
std::vector<std::string> linkFlagsIn(SandboxChoice sandbox, bool isSanitised) {
  std::vector<std::string> flags = checkLinkFlags(isSanitised);
  if (sandbox == SandboxChoice::Landlock) std::erase(flags, build_paths::linkerFlag);
  return flags;
}

std::string joined(const std::vector<std::string>& words) { return fmt::format("{}", fmt::join(words, " ")); }

/// The precompiled header is large: it is mounted, and handed over as content only when that cannot be.
void addPrelude(const Workplace& workplace, Confinement& confinement) {
  if (const auto folder = sharedPrelude(workplace)) {
    confinement.renamedFolders[folder->string()] = "/prelude";
  } else {
    confinement.files.push_back({"/prelude/prelude.h.gch", workplace.prelude(), "", false});
  }
}

/// The header was precompiled with the plain flags. What it holds is there all the same, under the same names, so that
/// no source can ask which build it is part of.
void addPlainPrelude(Confinement& confinement) {
  confinement.files.push_back({"/prelude/prelude.h", {}, "#include \"harness/exercise.h\"\n", false});
  confinement.files.push_back({"/prelude/prelude.h.gch", {}, "none", false});
}

bool fitsNoPrelude(Build build) { return build == Build::Sanitised || build == Build::Refilled; }

std::vector<std::string> compileFlags(Build build) {
  if (build == Build::Sanitised) return sanitizedCompileFlags();
  return build == Build::Refilled ? refilledCompileFlags() : studentCompileFlags();
}

Confinement confinementOf(const Workplace& workplace, const Manifest& manifest, const Sources& sources,
                          SandboxChoice sandbox, Build build) {
  Confinement confinement;
  confinement.files = compilersView(workplace, manifest);
  for (const auto& [name, content] : sources) {
    std::string text = content;
    if (build == Build::Sanitised) text = withFilledFlags(content);
    if (build == Build::Refilled) text = withFilledNumbers(content);
    confinement.files.push_back({"/submission/" + name, {}, text, false});
  }
  if (fitsNoPrelude(build)) {
    addPlainPrelude(confinement);
  } else {
    addPrelude(workplace, confinement);
  }
  if (!isOfTheSystem(workplace.compiler)) {
    confinement.files.push_back({"/tools/" + workplace.compiler.filename().string(), workplace.compiler, "", true});
  }
  confinement.command = {"/usr/bin/sh", "-c", compileScript(workplace, sources, sandbox, build)};
  confinement.systemFolders = {"/usr/bin", "/usr/lib", "/usr/include"};
  if (fs::exists("/usr/lib64")) confinement.systemFolders.emplace_back("/usr/lib64");
  confinement.renamedFolders[build_paths::eigen] = "/eigen";
  confinement.scratchBytes = scratchBytes;
  confinement.limits.addressSpace = workplace.limits.memory;
  confinement.limits.fileSize = workplace.limits.product;
  // A copy of the precompiled header is written under the same limit.
  if (const auto copy = std::ranges::find(confinement.files, workplace.prelude(), &VisibleFile::source);
      copy != confinement.files.end()) {
    confinement.limits.fileSize = std::max<std::size_t>(workplace.limits.product, fs::file_size(copy->source));
  }
  confinement.limits.cpuSeconds = static_cast<unsigned>(workplace.limits.processorTime.count());
  return confinement;
}

Compilation::Stage stageOf(const CommandResult& run) {
  if (run.timedOut || run.status.signalled) return Compilation::Stage::Elsewhere;
  switch (run.status.code) {
    case 0:
      return Compilation::Stage::Done;
    case compileFailed:
      return Compilation::Stage::Compiling;
    case linkFailed:
      return Compilation::Stage::Linking;
    default:
      return Compilation::Stage::Elsewhere;
  }
}

}  // namespace

std::vector<VisibleFile> compilersView(const Workplace& workplace, const Manifest& manifest) {
  std::vector<VisibleFile> files;
  for (const auto& entry : fs::directory_iterator(workplace.harness())) {
    if (entry.path().extension() != ".h") continue;
    files.push_back({"/framework/harness/" + entry.path().filename().string(), entry.path(), "", false});
  }
  std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) { return a.inside < b.inside; });
  files.push_back({"/contract/" + manifest.topic + ".h", workplace.contract(manifest.topic), "", false});
  files.push_back({"/glue.a", workplace.glue(manifest.topic), "", false});
  return files;
}

/// Runs in the sandbox's root folder, which only some backends can make "/". Nothing of the student's runs here, only
/// compiler, nm and linker do, each watched; the product leaves by stdout, the lists of what was read and of symbols by
/// descriptor 3.
std::string compileScript(const Workplace& workplace, const Sources& sources, SandboxChoice sandbox, Build build) {
  const bool isSanitised = build == Build::Sanitised;
  const std::string compiler = insideOf(workplace.compiler);
  std::string script = "cd tmp\n";
  for (const auto& [name, content] : sources) {
    const std::string object = fs::path(name).stem().string() + ".o";
    script += fmt::format(
        "{}{} {}{} -I../prelude -include prelude.h -I../contract -I../framework -isystem ../eigen {} -c "
        "../submission/{} "
        "-o {} || exit {}\n",
        compilesWithClang() ? ToolWatch::command() : "", compiler, ToolWatch::compilerFlag(),
        joined(compileFlags(build)), joined(dependencyFlags(object)), name, object, compileFailed);
    script += fmt::format("cat {} >&3 || exit {}\n", joined(dependencyLists(object)), symbolsFailed);
  }
  return script + fmt::format(
                      "echo '{0}' >&3; {1}nm -P *.o >&3 || exit {2}\n"
                      "{3} {4}{5}{6} {7} *.o {8} -o submission.so || exit {9}\n"
                      "cat submission.so\n",
                      symbolsFollow, ToolWatch::command(), symbolsFailed, compiler, ToolWatch::linkerFlag(), linkFlags,
                      isSanitised ? "" : " -Wl,-z,defs",  // the host has the sanitizers' own symbols
                      joined(linkFlagsIn(sandbox, isSanitised)),
                      build == Build::Probe ? "" : "-Wl,--whole-archive ../glue.a -Wl,--no-whole-archive", linkFailed);
}

CompilePlace placeInSandbox() {
  return {"/tmp", {"/submission", "/contract", "/framework/harness", "/eigen", "/prelude"}};
}

std::string compilerIdentity(const Workplace& workplace) {
  std::string identity = std::string(__VERSION__) + build_paths::linkerFlag;
  std::error_code missing;
  for (const fs::path& tool : {workplace.compiler, fs::path("/usr/bin/mold"), fs::path("/usr/bin/ld")}) {
    if (fs::is_regular_file(tool, missing)) identity += digestOfFile(tool);
  }
  return identity;
}

Compilation compile(const Workplace& workplace, const Manifest& manifest, const Sources& sources,
                    const Sandbox& sandbox, Build build) {
  Compilation compilation;
  Capture capture;
  capture.limit = workplace.limits.wall;
  capture.outBytes = workplace.limits.product;
  capture.errBytes = workplace.limits.words;
  capture.reportBytes = symbolBytes;
  Confinement confinement = confinementOf(workplace, manifest, sources, sandbox.choice(), build);
  const ToolWatch watch;
  watch.addTo(confinement);
  compilation.run = sandbox.run(confinement, capture);
  compilation.stage = stageOf(compilation.run);
  compilation.endedFromOutside = compilation.stage != Compilation::Stage::Done && !watch.sawOwnFailure();
  const std::string& report = compilation.run.report;
  const std::size_t end = report.find(std::string(symbolsFollow) + "\n");
  compilation.dependencies = report.substr(0, end);
  if (end != std::string::npos) compilation.symbols = report.substr(end);
  return compilation;
}

}  // namespace muelle::grader
