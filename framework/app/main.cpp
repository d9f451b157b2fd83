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

using AddCommand = void (*)(muelle::CommandLine&);

/// In the order of --help.
constexpr AddCommand commands[] = {
    addCheck, addList,
#if MUELLE_HAS_GRADER
    addGrade, addTestTheTests, addClean,
#endif
#if MUELLE_HAS_ENGINE
    addRun,   addRest,         addAdvise, addHardCases, addBench, addFigures,
#endif
    addTest,  addDocs,
};

/// Whatever is asked for, an author is told what is still to be written.
void nameUnfinished() {
  for (const auto& [topic, files] : muelle::unfinishedExercises(muelle::build_paths::binary)) {
    // A student has deleted something of it.
    std::fputs(muelle::sayChanged(muelle::changedHandedOut(muelle::build_paths::source, topic)).c_str(), stderr);
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
  for (const AddCommand add : commands) add(program);
  return program.run(argc, argv);
}

}  // namespace

int main(int argc, char** argv) {
  return muelle::withErrorsOnOneLine([=] { return run(argc, argv); });
}
