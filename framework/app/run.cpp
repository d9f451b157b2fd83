#include "app/commands.h"
#include "app/process.h"
#include "harness/build_paths.h"

#include <filesystem>
#include <stdexcept>

namespace muelle::app {

namespace {

/// The engine is a program of its own, so that the other commands do not wait until it is built.
int run(const CLI::App& command) {
  const std::filesystem::path program = std::filesystem::path(build_paths::binary) / "bin" / "muelle-run";
  if (!std::filesystem::exists(program)) {
    throw std::runtime_error("the engine is not built; ./muelle run builds it, or: cmake --build build -t muelle-run");
  }
  std::vector<std::string> words = {program.string()};
  for (const std::string& word : command.remaining()) words.push_back(word);
  return runInForeground(words);
}

}  // namespace

void addRun(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("run", "Simulate a scene: summary, error estimate, figures");
  command->set_help_flag();  // muelle-run has the options, and says what they mean
  command->prefix_command();
  command->callback([command, &status] { status = run(*command); });
}

}  // namespace muelle::app
