#include "app/instructor/commands.h"
#include "base/build_paths.h"
#include "grader/authoring/scaffold.h"

#include <fmt/format.h>
#include <memory>

namespace muelle::app {

namespace {

int scaffold(const std::string& topic) {
  const std::filesystem::path checkout = build_paths::source;
  const grader::Tree files = grader::scaffoldOf(checkout, topic);
  grader::writeScaffold(checkout, topic, files);
  for (const auto& [file, text] : files) fmt::print("{}\n", file);
  fmt::print(
      "\nAn exercise that builds: a sample, with \"{}\" in each line that you have to write.\n"
      "next: ./muelle check {} --file solutions/{}/{}.cpp\n"
      "      ./muelle lint {}\n",
      grader::writeMark, topic, topic, topic, topic);
  return 0;
}

}  // namespace

void addNew(CommandLine& program) {
  const auto topic = std::make_shared<std::string>();
  CommandLine& command = program.command("new", "Begin an exercise: all its files, as a sample that builds");
  command.option("TOPIC", *topic, "The name of its folders: words of a-z and digits with _ between, as hanging_chain")
      .required();
  command.footer(
      "It writes exercises/TOPIC, solutions/TOPIC, tests/hidden/TOPIC and tests/submissions/TOPIC. What you have to "
      "write\n"
      "is marked WRITE:, and fails until you have; ./muelle lint TOPIC lists it. docs/writing_an_exercise.md is the "
      "guide.\n"
      "Example: ./muelle new hanging_chain");
  command.action([topic] { return scaffold(*topic); });
}

}  // namespace muelle::app
