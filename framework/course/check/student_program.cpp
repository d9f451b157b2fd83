#include "course/check/student_program.h"

#include "base/build_paths.h"
#include "base/file.h"
#include "base/process/child.h"
#include "base/text/lists.h"
#include "base/text/printable.h"
#include "course/check/compile_rules.h"
#include "course/check/compile_verdict.h"
#include "course/check/compile_view.h"
#include "course/check/dependencies.h"
#include "course/check/filled_flags.h"
#include "course/check/missing_functions.h"
#include "course/check/probe.h"
#include "course/check/second_look.h"
#include "course/check/source_text.h"
#include "course/check/symbols.h"
#include "course/unfinished.h"

#include <fmt/format.h>
#include <algorithm>
#include <functional>
#include <stdexcept>

namespace muelle {

namespace fs = std::filesystem;

namespace {

// What a slot of the build folder holds, beside the variants of the program.
constexpr const char* programName = "program";
constexpr const char* warningsName = "warnings";
constexpr const char* stampName = "stamp";

/// The compiler as driver of itself or of the linker, in the C locale: its words are read.
ToolRun runTool(const std::vector<std::string>& command, const CompileLimits& limits) {
  ChildSpec spec;
  spec.command = command;
  spec.inheritsEnvironment = true;
  spec.environment = {"LC_ALL=C"};
  spec.limits.cpuSeconds = static_cast<unsigned>(limits.processorTime.count());
  spec.limits.fileSize = limits.product;
#ifndef __APPLE__
  spec.limits.addressSpace = limits.memory;
#endif
  const CommandResult result = runCommand(spec, {limits.wall, limits.words, 0, 0, true});
  const ExitStatus& status = result.status;
  return {.words = result.out,
          .succeeded = !result.timedOut && status.success(),
          .timedOut = result.timedOut,
          .signal = status.signalled ? status.code : 0,
          .processorSeconds = status.cpuSeconds,
          .wordsCut = result.outCut};
}

/// One line for each file that the program is made of: any change changes the text.
std::string fingerprintOf(const std::vector<fs::path>& files) {
  std::string text = fmt::format("{} {}\n{:016x}\n", build_paths::compiler, joined(studentCompileFlags(), " "),
                                 std::hash<std::string>{}(symbolRules()));
  for (const fs::path& file : files) {
    std::error_code error;
    const auto size = fs::file_size(file, error);
    const auto time = fs::last_write_time(file, error);
    text += fmt::format("{} {} {}\n", file.string(), error ? 0 : size,
                        error ? 0 : static_cast<long long>(time.time_since_epoch().count()));
  }
  return text;
}

/// The builder of one program: its inputs and its slot in the build folder.
class Builder {
 public:
  Builder(const Manifest& manifest, const std::vector<fs::path>& sources, const CheckFolders& folders)
      : topic_(manifest.topic), callSeconds_(manifest.callSeconds), sources_(sources) {
    for (const fs::path& source : sources_) read(source);
    contract_ = folders.exercises / topic_ / (topic_ + ".h");
    parts_ = folders.build / "check" / (topic_ + ".parts");
    const auto unfinished = unfinishedExercises(folders.build);
    if (const auto found = unfinished.find(topic_); found != unfinished.end()) {
      throw std::runtime_error(sayUnfinished(topic_, found->second));
    }
    if (const fs::path lacks = missingPart(); !lacks.empty()) {
      throw std::runtime_error(
          fmt::format("{} is not in the build ({} was not made); ./muelle check makes it, or: cmake --build build -t "
                      "muelle_checking",
                      topic_, lacks.filename().string()));
    }
    // A file elsewhere (--file) has a slot of its own, so that it does not push out the student's.
    const std::size_t place = std::hash<std::string>{}(fs::absolute(sources_.front().parent_path()).string());
    slot_ = folders.build / "check" / fmt::format("{}-{:016x}", topic_, place);
  }

  StudentProgram build() {
    StudentProgram program;
    program.students = students_;
    program.callSeconds = callSeconds_;
    program.note = note_;
    if (!refusal_.empty()) {
      program.outcome = Outcome::Refused;
      program.message = refusal_;
      return program;
    }
    program.fingerprint = fingerprintOf(inputs());
    if (tryReadFile(slot_ / stampName) == program.fingerprint) return kept(program);
    const TemporaryFolder scratch(slot_);
    const CompileView view(scratch.path(), contract_, students_);
    std::vector<std::string> objects;
    if (!compileAll(view, scratch.path(), objects, program)) return program;
    if (!judgeObjects(objects, program)) return program;
    if (!linkAll(view, scratch.path(), objects, program)) return program;
    publish(view, scratch.path(), program);
    return kept(program);
  }

 private:
  /// Of every file its object; false when one cannot be used.
  bool compileAll(const CompileView& view, const fs::path& scratch, std::vector<std::string>& objects,
                  StudentProgram& program) {
    for (const StudentFile& file : students_) {
      objects.push_back(objectOf(file, scratch, ".o"));
      CompileVerdict verdict = decided(view, scratch, [&] { return compile(view, file, objects.back()); });
      if (!verdict.hidden.empty()) {
        hidden_ = verdict.hidden;
        verdict = decided(view, scratch, [&] { return compile(view, file, objects.back()); });
      }
      program.diagnostics += verdict.diagnostics;
      if (!take(verdict, program)) return false;
    }
    return true;
  }

  /// The program that runs; functions that are missing only cost the tests that call them.
  bool linkAll(const CompileView& view, const fs::path& scratch, std::vector<std::string>& objects,
               StudentProgram& program) {
    const fs::path fresh = scratch / programName;
    CompileVerdict linked = decided(view, scratch, [&] { return link(objects, fresh); });
    if (!linked.missing.empty() && addMissing(view, linked.missing, objects)) {
      program.diagnostics = linked.diagnostics + program.diagnostics;
      linked = decided(view, scratch, [&] { return link(objects, fresh); });
    }
    if (!linked.passed()) program.diagnostics = linked.diagnostics;
    return take(linked, program);
  }

  /// Puts the program and the variants of it that are of use into the slot.
  void publish(const CompileView& view, const fs::path& scratch, const StudentProgram& program) {
    const std::string hindrance = wantsSecondLook_ ? buildAgain(view, scratch, sanitized) : "";
    const bool looksTwice = wantsSecondLook_ && hindrance.empty();
    const bool fillsTwice = wantsOtherFill_ && buildAgain(view, scratch, refilled).empty();
    // The stamp last: whoever reads it finds the program and the warnings that belong to it.
    fs::remove(slot_ / stampName);
    for (const Variant& variant : {sanitized, refilled}) fs::remove(slot_ / variant.name);
    fs::rename(scratch / programName, slot_ / programName);
    if (looksTwice) fs::rename(scratch / sanitized.name, slot_ / sanitized.name);
    if (fillsTwice) fs::rename(scratch / refilled.name, slot_ / refilled.name);
    writeFile(slot_ / warningsName, program.diagnostics + hindrance);
    writeFile(slot_ / stampName, program.fingerprint);
  }

  /// Compiles a definition of each function that is missing; a call of one says so.
  bool addMissing(const CompileView& view, const std::vector<std::string>& functions,
                  std::vector<std::string>& objects) {
    const fs::path source = view.source(missingSourceName);
    writeFile(source, missingSource(functions, students_, readFile(contract_), contract_.filename().string()));
    missingObject_ = source.string() + ".o";
    if (!runTool(compileCommand(view, source, missingObject_, nullptr), limits_).succeeded) return false;
    objects.push_back(missingObject_);
    return true;
  }

  /// The first file of ours that the program needs and the build has not made, else empty: nobody's file is to blame.
  fs::path missingPart() const {
    if (!fs::exists(parts_)) return parts_;
    const std::vector<fs::path> parts = fileParts();
    const auto missing = std::ranges::find_if(parts, [](const fs::path& part) { return !fs::exists(part); });
    return missing == parts.end() ? fs::path() : *missing;
  }

  /// The files of ours that the program is linked with.
  std::vector<fs::path> fileParts() const {
    std::vector<fs::path> files;
    for (const std::string& word : readParts(readFile(parts_))) {
      if (!word.starts_with("-")) files.emplace_back(word);
    }
    return files;
  }

  /// As the grader's intake reads it: what is no text, or too much of it, is refused before it meets the compiler.
  void read(const fs::path& source) {
    if (!fs::is_regular_file(source)) throw std::runtime_error(fmt::format("no file {}", source.string()));
    const std::string name = source.filename().string();
    const std::string bytes = readFile(source);
    const SourceText text = readSource(bytes);
    if (bytes.size() > largestSource) {
      refusal_ = fmt::format("{} is larger than {} KiB", name, largestSource >> 10U);
    } else if (!text.refusal.empty()) {
      refusal_ = fmt::format("{} {}", name, text.refusal);
    }
    if (!text.note.empty()) note_ += fmt::format("{}{}: {}", note_.empty() ? "" : "; ", name, text.note);
    students_.push_back({name, text.text});
  }

  /// What stands in the slot.
  StudentProgram kept(StudentProgram program) const {
    program.executable = slot_ / programName;
    program.diagnostics = readFile(slot_ / warningsName);
    if (fs::exists(slot_ / sanitized.name)) program.sanitized = slot_ / sanitized.name;
    if (fs::exists(slot_ / refilled.name)) program.refilled = slot_ / refilled.name;
    return program;
  }

  /// True when the step is done; else its reason goes into the program.
  static bool take(const CompileVerdict& verdict, StudentProgram& program) {
    program.outcome = verdict.outcome;
    program.message = verdict.message;
    return verdict.passed();
  }

  /// What was killed is tried once more; what no word decides is decided by a file that is known to be good.
  /// Throws std::runtime_error when the machine is to blame.
  template <class Step>
  CompileVerdict decided(const CompileView& view, const fs::path& scratch, const Step& step) const {
    CompileVerdict verdict = step();
    if (!verdict.isDecided && verdict.wasKilled) verdict = step();
    if (!verdict.isDecided) verdict = afterProbe(verdict, probeBuilds(view, scratch));
    if (verdict.isOurs) {
      throw std::runtime_error(fmt::format("{}; nothing is wrong with your file so far\n{}", verdict.message,
                                           cutText(verdict.diagnostics, 3, 500)));
    }
    return verdict;
  }

  bool probeBuilds(const CompileView& view, const fs::path& scratch) const {
    const fs::path source = view.source("probe.cpp");
    const std::string object = (scratch / "probe.o").string();
    writeFile(source, probeSource(students_, contract_.filename().string()));
    if (!runTool(compileCommand(view, source, object, nullptr), limits_).succeeded) return false;
    std::vector<std::string> command{build_paths::compiler, "-shared", object, "-o", (scratch / "probe.so").string()};
    for (const std::string& flag : checkLinkFlags(false)) command.push_back(flag);
    return runTool(command, limits_).succeeded;
  }

  std::vector<fs::path> inputs() const {
    std::vector<fs::path> files = sources_;
    files.push_back(contract_);
    files.push_back(fs::path(build_paths::prelude) / "prelude.h.gch");
    files.push_back(parts_);
    for (fs::path& part : fileParts()) files.push_back(std::move(part));
    return files;
  }

  static std::string objectOf(const StudentFile& file, const fs::path& scratch, const char* ending) {
    return (scratch / fs::path(file.name).stem()).string() + ending;
  }

  /// One more build, whose flags fit no precompiled header.
  struct Variant {
    const char* name;
    std::vector<std::string> (*flags)();
    std::string (*filled)(std::string_view source);
    bool isSanitized;
  };
  static constexpr Variant sanitized{"sanitized", sanitizedCompileFlags, withFilledFlags, true};
  static constexpr Variant refilled{"refilled", refilledCompileFlags, withFilledNumbers, false};

  /// \param variant null: the plain build
  std::vector<std::string> compileCommand(const CompileView& view, const fs::path& source, const std::string& object,
                                          const Variant* variant) const {
    std::vector<std::string> command{build_paths::compiler};
    const auto add = [&](const std::vector<std::string>& flags) {
      command.insert(command.end(), flags.begin(), flags.end());
    };
    add(variant != nullptr ? variant->flags() : studentCompileFlags());
    if (!hidden_.empty()) add({"-fpermissive"});
    add(view.includeFlags(variant == nullptr));
    add(dependencyFlags(object));
    add({"-c", source.string(), "-o", object});
    return command;
  }

  /// GCC has taken a static function for what the contract says of it; nobody else may find it, as in the grader.
  void hideStatic(const std::string& object) const {
    for (const std::string& function : hidden_) {
      const std::string symbols = fmt::format("--localize-symbol=_Z{}{}*", function.size(), function);
      runTool({"objcopy", "-w", symbols, object}, limits_);
    }
  }

  CompileVerdict compile(const CompileView& view, const StudentFile& file, const std::string& object) {
    const ToolRun run = runTool(compileCommand(view, view.source(file.name), object, nullptr), limits_);
    if (run.succeeded) hideStatic(object);
    if (run.succeeded && wantsSecondLook(run, students_)) wantsSecondLook_ = true;
    if (run.succeeded && wantsOtherFill(run, students_)) wantsOtherFill_ = true;
    const CompileVerdict verdict = judgeCompilation(run, students_, limits_);
    if (!verdict.passed()) return verdict;
    std::string lists;
    for (const std::string& list : dependencyLists(object)) lists += readFile(list);
    const CompileVerdict read = judgeDependencies(lists, view.place(), students_);
    return read.passed() ? verdict : read;
  }

  /// `nm -P` of the objects. Throws std::runtime_error when it is missing or fails: a file that the grader refuses by
  /// what it uses must not pass here.
  std::string symbolsOf(const std::vector<std::string>& objects) const {
    std::string reason;
    try {
      const ToolRun run = runTool(symbolsCommand(objects), {.words = 1U << 20U});
      if (run.succeeded) return run.words;
      reason = printableLine(run.words.substr(0, run.words.find('\n')));
    } catch (const std::runtime_error& error) {
      reason = error.what();
    }
    throw std::runtime_error(fmt::format(
        "nm did not list what {} uses ({}), so that it cannot be judged as it is graded: install nm, of the "
        "package binutils (on macOS: xcode-select --install)",
        students_.front().name, reason));
  }

  bool judgeObjects(const std::vector<std::string>& objects, StudentProgram& program) const {
    const SymbolVerdict verdict = judgeSymbols(readSymbols(symbolsOf(objects)));
    if (verdict.outcome == Outcome::Passed) return true;
    program.outcome = verdict.outcome;
    program.message = verdict.message;
    program.diagnostics += verdict.message + "\n";
    return false;
  }

  std::vector<std::string> linkCommand(const std::vector<std::string>& objects, const fs::path& executable,
                                       bool isSanitized) const {
    std::vector<std::string> command{build_paths::compiler};
    for (const std::string& object : objects) command.push_back(object);
    for (const std::string& part : readParts(readFile(parts_))) command.push_back(part);
    for (const std::string& flag : checkLinkFlags(isSanitized)) command.push_back(flag);
    command.insert(command.end(), {"-o", executable.string()});
    return command;
  }

  CompileVerdict link(const std::vector<std::string>& objects, const fs::path& executable) const {
    const ToolRun run = runTool(linkCommand(objects, executable, false), limits_);
    return judgeLink(run, students_, readFile(contract_), contract_.filename().string(), limits_);
  }

  /// The source, or a copy where variables that nobody sets are filled, under its name.
  static fs::path filledCopy(const CompileView& view, const StudentFile& file, const fs::path& scratch,
                             const Variant& variant) {
    const std::string text = variant.filled(file.text);
    if (text == file.text) return view.source(file.name);
    const fs::path folder = scratch / (std::string(variant.name) + "_source");
    fs::create_directories(folder);
    writeFile(folder / file.name, text);
    return folder / file.name;
  }

  /// Why it does not come about, which costs nobody anything; "" when it does.
  std::string buildAgain(const CompileView& view, const fs::path& scratch, const Variant& variant) const {
    std::vector<std::string> objects;
    for (const StudentFile& file : students_) {
      objects.push_back(objectOf(file, scratch, fmt::format("_{}.o", variant.name).c_str()));
      const fs::path source = filledCopy(view, file, scratch, variant);
      const ToolRun run = runTool(compileCommand(view, source, objects.back(), &variant), limits_);
      if (!run.succeeded) return sayNoSecondLook(run, students_);
      hideStatic(objects.back());
    }
    if (!missingObject_.empty()) objects.push_back(missingObject_);
    const ToolRun run = runTool(linkCommand(objects, scratch / variant.name, variant.isSanitized), limits_);
    return run.succeeded ? "" : sayNoSecondLook(run, students_);
  }

  std::string topic_;
  int callSeconds_;
  std::vector<fs::path> sources_;
  std::vector<StudentFile> students_;
  fs::path contract_;
  fs::path parts_;
  fs::path slot_;
  CompileLimits limits_;
  bool wantsSecondLook_ = false;
  bool wantsOtherFill_ = false;
  std::vector<std::string> hidden_;  ///< functions of the contract that the files make static
  std::string missingObject_;        ///< defines what the files lack; "" when they lack nothing
  std::string refusal_;              ///< why a source is not compiled at all; "" when all are
  std::string note_;
};

}  // namespace

CheckFolders checkFolders() {
  const fs::path source = build_paths::source;
  return {source / "exercises", build_paths::binary, source / "out"};
}

StudentProgram buildStudentProgram(const Manifest& manifest, const std::vector<fs::path>& sources,
                                   const CheckFolders& folders) {
  return Builder(manifest, sources, folders).build();
}

}  // namespace muelle
