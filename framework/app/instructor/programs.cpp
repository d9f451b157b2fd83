/// \file
/// The engine's commands: programs of their own, so that the other commands do not wait until they are built.

#include "app/commands.h"
#include "base/build_paths.h"
#include "base/process/child.h"

#include <fmt/format.h>
#include <filesystem>
#include <stdexcept>

namespace muelle::app {

namespace {

int runProgram(const CLI::App& command) {
  const std::string name = "muelle-" + command.get_name();
  const std::filesystem::path program = std::filesystem::path(build_paths::binary) / "bin" / name;
  if (!std::filesystem::exists(program)) {
    throw std::runtime_error(fmt::format("{} is not built; ./muelle {} builds it, or: cmake --build build -t {}", name,
                                         command.get_name(), name));
  }
  std::vector<std::string> words = {program.string()};
  for (const std::string& word : command.remaining()) words.push_back(word);
  return runInForeground(words);
}

/// The program `muelle-NAME` gets all that follows: it has the options, and says what they mean.
void addProgram(CLI::App& app, int& status, const std::string& name, const std::string& description) {
  CLI::App* command = app.add_subcommand(name, description);
  command->set_help_flag();
  command->prefix_command();
  command->callback([command, &status] { status = runProgram(*command); });
}

}  // namespace

void addRun(CLI::App& app, int& status) {
  addProgram(app, status, "run", "Simulate a scene: summary, error estimate, figures");
}

void addHardCases(CLI::App& app, int& status) {
  addProgram(app, status, "hard-cases", "Every method of the engine on every hard case: predicted first, then run");
}

void addFigures(CLI::App& app, int& status) { addProgram(app, status, "figures", "Draw the figures of the lecture"); }

}  // namespace muelle::app
