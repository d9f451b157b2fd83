#include "course/check/student_program.h"

#include "base/build_paths.h"
#include "base/file.h"
#include "base/process/child.h"
#include "course/check/diagnostics.h"

#include <fmt/format.h>
#include <functional>
#include <sstream>
#include <stdexcept>

namespace muelle {

namespace fs = std::filesystem;

namespace {

constexpr std::chrono::seconds compileTime{60};

/// The compiler as driver of itself or of the linker, in the C locale: its words are read.
CommandResult runTool(const std::vector<std::string>& command) {
  ChildSpec spec;
  spec.command = command;
  spec.inheritsEnvironment = true;
  spec.environment = {"LC_ALL=C"};
  return runCommand(spec, {compileTime, 1U << 20U, 0, 0, true});
}

std::vector<std::string> words(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> result;
  for (std::string word; stream >> word;) result.push_back(word);
  return result;
}

/// One line for each file that the program is made of: any change changes the text.
std::string fingerprintOf(const std::vector<fs::path>& files) {
  std::string text = fmt::format("{} {}\n", build_paths::compiler, build_paths::studentFlags);
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
      : topic_(manifest.topic), sources_(sources), folders_(folders) {
    for (const fs::path& source : sources_) {
      if (!fs::is_regular_file(source)) throw std::runtime_error(fmt::format("no file {}", source.string()));
      students_.push_back({source.filename().string(), readFile(source)});
    }
    contract_ = folders.exercises / topic_ / (topic_ + ".h");
    parts_ = folders.build / "check" / (topic_ + ".rsp");
    if (!fs::exists(parts_)) {
      throw std::runtime_error(
          fmt::format("{} is not in the build ({} was not made): its folder lacks a file, which CMake names when it "
                      "configures",
                      topic_, parts_.filename().string()));
    }
    // A file elsewhere (--file) has a slot of its own, so that it does not push out the student's.
    const std::size_t place = std::hash<std::string>{}(fs::absolute(sources_.front().parent_path()).string());
    slot_ = folders.build / "check" / fmt::format("{}-{:016x}", topic_, place);
  }

  StudentProgram build() {
    StudentProgram program;
    program.fingerprint = fingerprintOf(inputs());
    const fs::path executable = slot_ / "program";
    const fs::path stamp = slot_ / "stamp";
    const fs::path warnings = slot_ / "warnings";
    if (fs::exists(stamp) && readFile(stamp) == program.fingerprint) {
      program.executable = executable;
      program.diagnostics = readFile(warnings);
      return program;
    }
    const TemporaryFolder scratch(slot_);
    std::vector<std::string> objects;
    for (const fs::path& source : sources_) {
      objects.push_back((scratch.path() / source.stem()).string() + ".o");
      if (!compile(source, objects.back(), program)) return program;
    }
    const fs::path fresh = scratch.path() / "program";
    if (!link(objects, fresh, program)) return program;
    // The stamp last: whoever reads it finds the program and the warnings that belong to it.
    fs::remove(stamp);
    fs::rename(fresh, executable);
    writeFile(warnings, program.diagnostics);
    writeFile(stamp, program.fingerprint);
    program.executable = executable;
    return program;
  }

 private:
  std::vector<fs::path> inputs() const {
    std::vector<fs::path> files = sources_;
    files.push_back(contract_);
    files.push_back(fs::path(build_paths::prelude) / "prelude.h.gch");
    files.push_back(parts_);
    for (const std::string& word : words(readFile(parts_))) {
      if (!word.starts_with("-")) files.emplace_back(word);
    }
    return files;
  }

  bool compile(const fs::path& source, const std::string& object, StudentProgram& program) const {
    std::vector<std::string> command{build_paths::compiler};
    for (const std::string& flag : words(build_paths::studentFlags)) command.push_back(flag);
    for (const std::string& flag : diagnosticFlags()) command.push_back(flag);
    const std::string framework = (fs::path(build_paths::source) / "framework").string();
    for (const std::string& word :
         {std::string("-I"), std::string(build_paths::prelude), std::string("-include"), std::string("prelude.h"),
          std::string("-I"), framework, std::string("-isystem"), std::string(build_paths::eigen), std::string("-I"),
          contract_.parent_path().string(), std::string("-c"), source.string(), std::string("-o"), object}) {
      command.push_back(word);
    }
    const CommandResult result = runTool(command);
    program.diagnostics += cutDiagnostics(result.out, students_);
    if (result.timedOut)
      program.diagnostics += fmt::format("the compiler did not end within {} s\n", compileTime.count());
    return result.status.success();
  }

  bool link(const std::vector<std::string>& objects, const fs::path& executable, StudentProgram& program) const {
    std::vector<std::string> command{build_paths::compiler};
    for (const std::string& object : objects) command.push_back(object);
    command.push_back("@" + parts_.string());
    if (*build_paths::linkerFlag != '\0') command.emplace_back(build_paths::linkerFlag);
    command.insert(command.end(), {"-pthread", "-o", executable.string()});
    const CommandResult result = runTool(command);
    if (result.status.success()) return true;
    program.diagnostics = explainLinkErrors(result.out, students_, readFile(contract_), contract_.filename().string());
    return false;
  }

  std::string topic_;
  std::vector<fs::path> sources_;
  const CheckFolders& folders_;
  std::vector<StudentFile> students_;
  fs::path contract_;
  fs::path parts_;
  fs::path slot_;
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
