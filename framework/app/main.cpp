/// \file
/// The `muelle` command: reads the command line and calls the rooms; decides nothing itself.

#include "app/commands.h"
#include "base/errors.h"
#include "base/text/nearest.h"
#include "base/text/printable.h"

#include <fmt/format.h>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace muelle::app;

using AddCommand = void (*)(CLI::App&, int&);

/// In the order of --help.
constexpr AddCommand commands[] = {
    addCheck, addList,
#if MUELLE_HAS_GRADER
    addGrade, addTestTheTests, addClean,
#endif
#if MUELLE_HAS_ENGINE
    addRun,   addHardCases,    addFigures,
#endif
    addTest,  addDocs,
};

/// CLI11 takes a mistyped command for a stray argument; its name deserves a better answer.
void refuseUnknownCommand(const CLI::App& app, const std::string& word) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  if (word.starts_with("-") || std::find(names.begin(), names.end(), word) != names.end()) return;
  throw std::invalid_argument(
      fmt::format("no command '{}'{}", muelle::printableLine(word), muelle::suggestion(word, names)));
}

int run(int argc, char** argv) {
  int status = 0;
  CLI::App app("A course on mass-spring simulation that runs.", "./muelle");
  app.footer("Every command has its own help: ./muelle check --help");
  for (const AddCommand add : commands) add(app, status);
  if (argc < 2) {
    printNextSteps();
    return 0;
  }
  refuseUnknownCommand(app, argv[1]);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    // Calls for help are "errors" too, with exit code 0.
    if (error.get_exit_code() == 0) return app.exit(error);
    throw std::invalid_argument(fmt::format("{} (see ./muelle {}--help)", error.what(),
                                            app.get_subcommands().empty() ? "" : std::string(argv[1]) + " "));
  }
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  return muelle::withErrorsOnOneLine([=] { return run(argc, argv); });
}
