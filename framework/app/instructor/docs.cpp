#include "app/instructor/commands.h"
#include "base/build_paths.h"
#include "base/process/child.h"

#include <fmt/format.h>
#include <filesystem>
#include <stdexcept>

namespace muelle::app {

namespace {

/// Doxygen's own configuration treats warnings as errors.
int docs() {
  const std::filesystem::path folder = std::filesystem::path(build_paths::source) / "docs";
  if (!std::filesystem::exists(folder / "Doxyfile")) {
    throw std::runtime_error("docs/Doxyfile is missing: this tree comes without its documentation");
  }
  std::filesystem::current_path(build_paths::source);
  std::filesystem::create_directories(std::filesystem::path(build_paths::binary) / "docs");
  if (runInForeground({"doxygen", "-q", "docs/Doxyfile"}) != 0) return 1;
  fmt::print("{}\n", (std::filesystem::path(build_paths::binary) / "docs" / "html" / "index.html").string());
  return 0;
}

}  // namespace

void addDocs(CommandLine& program) {
  CommandLine& command = program.command("docs", "Write the documentation as web pages");
  command.footer("Example: ./muelle docs");
  command.action([] { return docs(); });
}

}  // namespace muelle::app
