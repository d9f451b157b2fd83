/// \file
/// The `muelle` command: reads the command line and calls the rooms; decides nothing itself.

#include "app/commands.h"
#include "base/build_paths.h"
#include "base/errors.h"
#include "course/check/handed_out.h"
#include "course/unfinished.h"

#include <cstdio>
#include <string>

namespace {

using namespace muelle::app;

/// Whatever is asked for, an author is told what is still to be written.
void nameUnfinished() {
  for (const auto& [topic, files] : muelle::unfinishedExercises(muelle::build_paths::binary)) {
    // A student has deleted something of it.
    std::fputs(muelle::sayChanged(muelle::build_paths::source, topic).c_str(), stderr);
    std::fputs(("muelle: " + muelle::sayUnfinished(topic, files) + "\n").c_str(), stderr);
  }
}

int run(int argc, char** argv) {
  nameUnfinished();
  muelle::CommandLine program("./muelle", "A course on mass-spring simulation that runs.");
  program.footer("Every command has its own help: ./muelle check --help");
  program.action([] {
    printNextSteps();
    return 0;
  });
  addCheck(program);
  addList(program);
#if MUELLE_HAS_INSTRUCTOR
  addInstructorCommands(program);
#endif
  return program.run(argc, argv);
}

}  // namespace

int main(int argc, char** argv) {
  return muelle::withErrorsOnOneLine([=] { return run(argc, argv); });
}
