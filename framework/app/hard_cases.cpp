#include "app/commands.h"
#include "app/process.h"
#include "harness/build_paths.h"

#include <filesystem>
#include <stdexcept>

namespace muelle::app {

namespace {

/// The matrix is a program of its own, so that the other commands do not wait until it is built.
int hardCases(const CLI::App& command) {
  const std::filesystem::path program = std::filesystem::path(build_paths::binary) / "bin" / "muelle-hard-cases";
  if (!std::filesystem::exists(program)) {
    throw std::runtime_error(
        "the hard cases are not built; ./muelle hard-cases builds them, or: cmake --build build -t muelle-hard-cases");
  }
  std::vector<std::string> words = {program.string()};
  for (const std::string& word : command.remaining()) words.push_back(word);
  return runInForeground(words);
}

}  // namespace

void addHardCases(CLI::App& app, int& status) {
  CLI::App* command =
      app.add_subcommand("hard-cases", "Every method of the engine on every hard case: predicted first, then run");
  command->set_help_flag();  // muelle-hard-cases has the options, and says what they mean
  command->prefix_command();
  command->callback([command, &status] { status = hardCases(*command); });
}

}  // namespace muelle::app
