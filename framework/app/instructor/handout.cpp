#include "grader/authoring/handout.h"
#include "app/instructor/commands.h"
#include "base/build_paths.h"
#include "base/text/count.h"

#include <fmt/format.h>
#include <cstdio>
#include <memory>
#include <stdexcept>

namespace muelle::app {

namespace {

struct HandoutCommand {
  std::string folder;
  bool force = false;
};

int handOut(const HandoutCommand& command) {
  const std::filesystem::path checkout = build_paths::source;
  const grader::Handout handout = grader::readHandout(checkout);
  for (const std::string& note : handout.notes) fmt::print(stderr, "note: {}\n", note);
  for (const grader::Leak& leak : handout.leaks) fmt::print(stderr, "{}\n", leak.text());
  if (!handout.leaks.empty()) {
    fmt::print("nothing was written: {} in what would be handed out; change the lines above\n",
               counted(static_cast<long long>(handout.leaks.size()), "leak"));
    return 1;
  }
  grader::writeHandout(handout, checkout, command.folder, command.force ? grader::Replace::Yes : grader::Replace::No);
  fmt::print("{}: {}, without a solution or a hidden test\nnext: cd {} && ./muelle check\n", command.folder,
             counted(static_cast<long long>(handout.tree.size()), "file"), command.folder);
  return 0;
}

}  // namespace

void addHandout(CommandLine& program) {
  const auto options = std::make_shared<HandoutCommand>();
  CommandLine& command = program.command("handout", "Write the tree that students clone");
  command.option("FOLDER", options->folder, "Where: a new or an empty folder").required();
  command.flag("--force", options->force, "Replace a student's tree that stands there, all but its .git");
  command.footer(
      "It holds the exercises, what checks and draws them, and a README for students; no solution, no hidden test, no\n"
      "engine, no grader. What would tell an answer stops it. Exit code: 0 written, 1 a leak was found, 2 bad usage.\n"
      "Examples: ./muelle handout ../muelle-students\n"
      "          ./muelle handout ../muelle-students --force   # again, after a change: commit and push it there");
  command.action([options] { return handOut(*options); });
}

}  // namespace muelle::app
