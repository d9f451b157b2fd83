#pragma once
/// \file
/// The subcommands of `muelle` that everyone has. Each function adds one to the command line. Its action returns the
/// exit code: 0 done, 1 a check failed; what it throws becomes 2, bad usage or input.

#include "base/command_line.h"

namespace muelle::app {

void addCheck(CommandLine& program);
void addList(CommandLine& program);

#if MUELLE_HAS_INSTRUCTOR
/// Those of app/instructor/, which is not handed out, in the order of --help.
void addInstructorCommands(CommandLine& program);
/// What of them one may type next.
void printInstructorSteps();
#endif

/// What `muelle` alone prints: the commands to type next.
void printNextSteps();

/// One of these commands, with the words that say what it is for.
void printStep(const char* command, const char* what);

}  // namespace muelle::app
