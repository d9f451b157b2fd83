/// \file
/// The engine's commands: programs of their own, so that the other commands do not wait until they are built.

#include "app/instructor/commands.h"
#include "base/build_paths.h"
#include "base/process/child.h"

#include <fmt/format.h>
#include <filesystem>
#include <memory>
#include <stdexcept>

namespace muelle::app {

namespace {

int runProgram(const std::string& command, const std::vector<std::string>& arguments) {
  const std::string name = "muelle-" + command;
  const std::filesystem::path program = std::filesystem::path(build_paths::binary) / "bin" / name;
  if (!std::filesystem::exists(program)) {
    throw std::runtime_error(
        fmt::format("{} is not built; ./muelle {} builds it, or: cmake --build build -t {}", name, command, name));
  }
  std::vector<std::string> words = {program.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  const int code = runInForeground(words);
  if (code > 128) throw std::runtime_error(fmt::format("{} was ended by signal {}", name, code - 128));
  return code;
}

/// The program `muelle-NAME` gets all that follows: it has the options, and says what they mean.
void addProgram(CommandLine& program, const std::string& name, const std::string& description) {
  const auto arguments = std::make_shared<std::vector<std::string>>();
  CommandLine& command = program.command(name, description);
  command.passOn(*arguments);
  command.action([name, arguments] { return runProgram(name, *arguments); });
}

}  // namespace

void addRun(CommandLine& program) { addProgram(program, "run", "Simulate a scene: summary, error estimate, figures"); }

void addRest(CommandLine& program) {
  addProgram(program, "rest", "Where a scene stands still: stable or not, tensions, figure");
}

void addAdvise(CommandLine& program) {
  addProgram(program, "advise", "The cheapest method, step and model for an error that one allows");
}

void addHardCases(CommandLine& program) {
  addProgram(program, "hard-cases", "Every method of the engine on every hard case: predicted first, then run");
}

void addBench(CommandLine& program) {
  addProgram(program, "bench", "Speed against error: every method, and the libraries one would take instead");
}

void addFigures(CommandLine& program) { addProgram(program, "figures", "Draw the figures of the lecture"); }

}  // namespace muelle::app
