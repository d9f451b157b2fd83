#include "app/commands.h"

namespace muelle::app {

void addCheck(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("check", "Check your file");
  command->callback([&status] { status = 2; });
}

}  // namespace muelle::app
