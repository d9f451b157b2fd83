#include "grader/run/compile.h"

#include "base/build_paths.h"
#include "base/text/lists.h"
#include "course/check/compile_rules.h"
#include "course/check/dependencies.h"
#include "course/check/filled_flags.h"
#include "course/check/missing_functions.h"
#include "grader/run/digest.h"
#include "grader/run/shared_prelude.h"
#include "grader/run/tool_watch.h"

#include <fmt/format.h>
#include <algorithm>
#include <cstdlib>
#include <string_view>

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

/// Before the size of the shared object, behind which the student's parts follow. The last line: what stands before it
/// holds names of the student's.
constexpr const char* partsFollow = "-- bytes ";

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

/// The compiler with its folders and limits; it has a scratch folder and sees the system's files.
Confinement toolsConfinement(const Workplace& workplace, std::string script) {
  Confinement confinement;
  if (!isOfTheSystem(workplace.compiler)) {
    confinement.files.push_back({"/tools/" + workplace.compiler.filename().string(), workplace.compiler, "", true});
  }
  confinement.command = {"/usr/bin/sh", "-c", std::move(script)};
  confinement.systemFolders = {"/usr/bin", "/usr/lib", "/usr/include"};
  if (fs::exists("/usr/lib64")) confinement.systemFolders.emplace_back("/usr/lib64");
  confinement.scratchBytes = scratchBytes;
  confinement.limits.addressSpace = workplace.limits.memory;
  confinement.limits.fileSize = workplace.limits.product;
  confinement.limits.cpuSeconds = static_cast<unsigned>(workplace.limits.processorTime.count());
  return confinement;
}

Confinement confinementOf(const Workplace& workplace, const Manifest& manifest, const Sources& sources,
                          SandboxChoice sandbox, Build build, const std::vector<std::string>& hidden) {
  Confinement confinement = toolsConfinement(workplace, compileScript(workplace, sources, sandbox, build, hidden));
  for (VisibleFile& file : compilersView(workplace, manifest)) confinement.files.push_back(std::move(file));
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
  confinement.renamedFolders[build_paths::eigen] = "/eigen";
  // A copy of the precompiled header is written under the same limit.
  if (const auto copy = std::ranges::find(confinement.files, workplace.prelude(), &VisibleFile::source);
      copy != confinement.files.end()) {
    confinement.limits.fileSize = std::max<std::size_t>(workplace.limits.product, fs::file_size(copy->source));
  }
  return confinement;
}

std::string linkFlagsText(SandboxChoice sandbox, Build build) {
  const bool isSanitised = build == Build::Sanitised;  // the host has the sanitizers' own symbols
  return fmt::format("{}{} {}", linkFlags, isSanitised ? "" : " -Wl,-z,defs",
                     joined(linkFlagsIn(sandbox, isSanitised), " "));
}

/// Takes the student's parts from behind the shared object.
void splitParts(Compilation& compilation) {
  std::string& report = compilation.run.report;
  const std::size_t line = report.rfind(partsFollow);
  if (line == std::string::npos) return;
  const std::size_t bytes = std::strtoul(report.c_str() + line + std::string_view(partsFollow).size(), nullptr, 10);
  report.resize(line);
  if (bytes > compilation.run.out.size()) return;
  compilation.parts = compilation.run.out.substr(bytes);
  compilation.run.out.resize(bytes);
}

/// Regular expression of the assembler's name of a function in the global namespace, whatever its arguments.
std::string assemblersName(const std::string& function) { return fmt::format("_Z{}{}", function.size(), function); }

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
/// compiler, nm and linker do, each watched; the product and the parts that it was linked of leave by stdout, the
/// lists of what was read and of symbols by descriptor 3.
std::string compileScript(const Workplace& workplace, const Sources& sources, SandboxChoice sandbox, Build build,
                          const std::vector<std::string>& hidden) {
  const std::string compiler = insideOf(workplace.compiler);
  std::string script = "cd tmp\n";
  for (const auto& [name, content] : sources) {
    const std::string object = fs::path(name).stem().string() + ".o";
    script += fmt::format(
        "{}{} {}{} -I../prelude -include prelude.h -I../contract -I../framework -isystem ../eigen {} -c "
        "../submission/{} "
        "-o {} || exit {}\n",
        compilesWithClang() ? ToolWatch::command() : "", compiler, ToolWatch::compilerFlag(),
        joined(compileFlags(build), " ") + (hidden.empty() ? "" : " -fpermissive"),
        joined(dependencyFlags(object), " "), name, object, compileFailed);
    for (const std::string& function : hidden) {  // GCC has taken it for what the contract says
      if (name == missingSourceName) continue;    // it defines what others find
      script += fmt::format("objcopy -w --localize-symbol='{}*' {} || exit {}\n", assemblersName(function), object,
                            symbolsFailed);
    }
    script += fmt::format("cat {} >&3 || exit {}\n", joined(dependencyLists(object), " "), symbolsFailed);
  }
  return script + fmt::format(
                      "echo '{0}' >&3; {1}nm -P *.o >&3 || exit {2}\n"
                      "{3} {4}{5} *.o {6} -o submission.so || exit {7}\n"
                      "{1}ld -r *.o -o parts || exit {2}\n"
                      "echo \"{8}$(wc -c < submission.so)\" >&3\n"
                      "cat submission.so parts\n",
                      symbolsFollow, ToolWatch::command(), symbolsFailed, compiler, ToolWatch::linkerFlag(),
                      linkFlagsText(sandbox, build),
                      build == Build::Probe ? "" : "-Wl,--whole-archive ../glue.a -Wl,--no-whole-archive", linkFailed,
                      partsFollow);
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
                    const Sandbox& sandbox, Build build, const std::vector<std::string>& hidden) {
  Compilation compilation;
  Capture capture;
  capture.limit = workplace.limits.wall;
  capture.outBytes = 2 * workplace.limits.product;  // with the parts
  capture.errBytes = workplace.limits.words;
  capture.reportBytes = symbolBytes;
  Confinement confinement = confinementOf(workplace, manifest, sources, sandbox.choice(), build, hidden);
  const ToolWatch watch;
  watch.addTo(confinement);
  compilation.run = sandbox.run(confinement, capture);
  compilation.stage = stageOf(compilation.run);
  compilation.endedFromOutside = compilation.stage != Compilation::Stage::Done && !watch.sawOwnFailure();
  splitParts(compilation);
  const std::string& report = compilation.run.report;
  const std::size_t end = report.find(std::string(symbolsFollow) + "\n");
  compilation.dependencies = report.substr(0, end);
  if (end != std::string::npos) compilation.symbols = report.substr(end);
  return compilation;
}

/// The reference's object has all functions of the contract. Those that are not asked for become its own, so that the
/// student's stay; the student's that are give way. A function of the student's that another one calls is found by its
/// name when it is called (-fPIC without -fvisibility or -fno-semantic-interposition): nothing has been put in its
/// place.
std::string replacingScript(const Workplace& workplace, const std::vector<std::string>& functions,
                            SandboxChoice sandbox, Build build) {
  std::vector<std::string> names;
  for (const std::string& function : functions) names.push_back("^" + assemblersName(function));
  return fmt::format(
      "cd tmp\n"
      "nm -P ../reference.o | sed -n 's/^\\([^ ]*\\) T .*/\\1/p' > all\n"
      "grep -E '{0}' all > asked || exit {1}\n"
      "grep -vE '{0}' all > others\n"
      "objcopy --weaken-symbols=asked ../parts.o student.o || exit {1}\n"
      "objcopy --localize-symbols=others ../reference.o reference.o || exit {1}\n"
      "{2} {3}{4} student.o reference.o -Wl,--whole-archive ../glue.a -Wl,--no-whole-archive -o submission.so || exit "
      "{1}\n"
      "cat submission.so\n",
      joined(names, "|"), linkFailed, insideOf(workplace.compiler), ToolWatch::linkerFlag(),
      linkFlagsText(sandbox, build));
}

std::optional<std::string> linkReplaced(const Workplace& workplace, const Manifest& manifest, const fs::path& parts,
                                        const std::vector<std::string>& functions, const Sandbox& sandbox,
                                        Build build) {
  Confinement confinement = toolsConfinement(workplace, replacingScript(workplace, functions, sandbox.choice(), build));
  confinement.files.push_back({"/parts.o", parts, "", false});
  confinement.files.push_back({"/reference.o", workplace.reference(manifest.topic), "", false});
  confinement.files.push_back({"/glue.a", workplace.glue(manifest.topic), "", false});
  const ToolWatch watch;
  watch.addTo(confinement);
  Capture capture;
  capture.limit = workplace.limits.wall;
  capture.outBytes = workplace.limits.product;
  capture.errBytes = workplace.limits.words;
  CommandResult run = sandbox.run(confinement, capture);
  if (run.timedOut || !run.status.success()) return std::nullopt;
  return std::move(run.out);
}

}  // namespace muelle::grader
