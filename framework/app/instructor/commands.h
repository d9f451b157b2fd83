#pragma once
/// \file
/// The subcommands of `muelle` that need more than what is handed out.

#include "base/command_line.h"

namespace muelle::app {

#if MUELLE_HAS_GRADER
void addGrade(CommandLine& program);
void addTestTheTests(CommandLine& program);
void addClean(CommandLine& program);
void addHandout(CommandLine& program);
void addLint(CommandLine& program);
void addNew(CommandLine& program);
#endif
#if MUELLE_HAS_ENGINE
void addRun(CommandLine& program);
void addRest(CommandLine& program);
void addAdvise(CommandLine& program);
void addHardCases(CommandLine& program);
void addBench(CommandLine& program);
void addFigures(CommandLine& program);
#endif
void addTest(CommandLine& program);
void addDocs(CommandLine& program);

}  // namespace muelle::app
