/// \file
/// check_outcome TOPIC SCRATCH FILE...: checks the files as `muelle check` does and prints the class of what came out,
/// then what it says. Exit code 2 when the machine is to blame. SCRATCH, a folder that may be written to, takes the
/// place of the build folder for what check builds.

#include "base/build_paths.h"
#include "course/check/exercise_check.h"

#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>

namespace {

namespace fs = std::filesystem;
using namespace muelle;

/// The list of what a student's file is linked with is all that check reads there.
CheckFolders foldersIn(const fs::path& scratch, const std::string& topic) {
  CheckFolders folders = checkFolders();
  const fs::path list = fs::path("check") / (topic + ".parts");
  fs::create_directories(scratch / "check");
  fs::copy_file(folders.build / list, scratch / list, fs::copy_options::overwrite_existing);
  folders.build = scratch;
  return folders;
}

std::string wordsOf(const TestReport& report) {
  std::string words = report.crash;
  for (const FailedTest& failure : report.failures) {
    words += "\n" + failure.suite + "." + failure.name + ": " + std::string(nameOf(failure.outcome)) + "\n" +
             showFailure(failure);
  }
  return words;
}

int run(const std::string& topic, const fs::path& scratch, const std::vector<fs::path>& sources) {
  const CheckFolders folders = foldersIn(scratch, topic);
  const Manifest manifest = readManifest(folders.exercises / topic / "exercise.toml");
  const StudentProgram program = buildStudentProgram(manifest, sources, folders);
  const TestReport report = program.executable.empty() ? TestReport() : runPublicTests(program);
  std::printf("%s\n%s\n%s\n", std::string(nameOf(checkOutcome(program, report))).c_str(), program.message.c_str(),
              wordsOf(report).c_str());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) return 2;
  try {
    return run(argv[1], argv[2], {argv + 3, argv + argc});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
