#include "app/commands.h"
#include "base/build_paths.h"
#include "course/manifest.h"

#include <fmt/format.h>
#include <filesystem>

namespace muelle::app {

namespace {

int list() {
  const std::vector<Manifest> course = readCourse(std::filesystem::path(build_paths::source) / "exercises");
  for (const Manifest& exercise : course) {
    fmt::print("{:2}  {:<16} {:>3} points  {}\n", exercise.order, exercise.topic, exercise.points, exercise.title);
  }
  return 0;
}

}  // namespace

void addList(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("list", "Name the exercises, in course order");
  command->footer("Example: ./muelle list");
  command->callback([&status] { status = list(); });
}

}  // namespace muelle::app
