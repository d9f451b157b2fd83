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

void addList(CommandLine& program) {
  CommandLine& command = program.command("list", "Name the exercises, in course order");
  command.footer("Example: ./muelle list");
  command.action([] { return list(); });
}

}  // namespace muelle::app
