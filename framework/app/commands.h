#pragma once
/// \file
/// The subcommands of `muelle`. Each function adds one to the command line. Its action returns the exit code:
/// 0 done, 1 a check failed; what it throws becomes 2, bad usage or input.

#include "base/command_line.h"

namespace muelle::app {

void addCheck(CommandLine& program);
void addList(CommandLine& program);
void addTest(CommandLine& program);
void addDocs(CommandLine& program);
#if MUELLE_HAS_GRADER
void addGrade(CommandLine& program);
void addTestTheTests(CommandLine& program);
void addClean(CommandLine& program);
#endif
#if MUELLE_HAS_ENGINE
void addRun(CommandLine& program);
void addRest(CommandLine& program);
void addAdvise(CommandLine& program);
void addHardCases(CommandLine& program);
void addBench(CommandLine& program);
void addFigures(CommandLine& program);
#endif

/// What `muelle` alone prints: the commands to type next.
void printNextSteps();

}  // namespace muelle::app
