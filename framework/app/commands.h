#pragma once
/// \file
/// The subcommands of `muelle`. Each function adds one to the command line; when it is called, the subcommand leaves
/// its exit code in `status`: 0 done, 1 a check failed, 2 bad usage or input.

#include <CLI/CLI.hpp>

namespace muelle::app {

void addCheck(CLI::App& app, int& status);
void addList(CLI::App& app, int& status);
void addTest(CLI::App& app, int& status);
void addDocs(CLI::App& app, int& status);
#if MUELLE_HAS_GRADER
void addGrade(CLI::App& app, int& status);
void addTestTheTests(CLI::App& app, int& status);
void addClean(CLI::App& app, int& status);
#endif
#if MUELLE_HAS_ENGINE
void addRun(CLI::App& app, int& status);
void addHardCases(CLI::App& app, int& status);
void addFigures(CLI::App& app, int& status);
#endif

/// What `muelle` alone prints: the commands to type next.
void printNextSteps();

}  // namespace muelle::app
