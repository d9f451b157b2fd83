#pragma once
#include "course/check/dependencies.h"
#include "grader/run/keys.h"
#include "grader/run/workplace.h"
#include "grader/sandbox/sandbox.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace muelle::grader {

/// What one run of compiler and linker in the sandbox left.
struct Compilation {
  enum class Stage { Compiling, Linking, Done, Elsewhere };
  Stage stage = Stage::Elsewhere;  ///< where it ended; Elsewhere: neither tool said so
  CommandResult run;               ///< out: the shared object; err: the tools' words
  std::string parts;               ///< the student's files alone, compiled into one object that can be linked again
  std::string dependencies;        ///< lists of what compiler and assembler have read, as make reads them
  std::string symbols;             ///< `nm -P` of the student's objects
  bool endedFromOutside = false;   ///< it failed, and no tool has been seen to fail by itself
};

/// Which build of a student's files.
enum class Build {
  Plain,
  Probe,      ///< a known good file that defines no function of the contract: linked without the glue
  Sanitised,  ///< with AddressSanitizer and a check for missing returns: for the second look
  Refilled,   ///< with another fill of what was never written
};

/// The files that a student's file may include, beside the system's and Eigen.
std::vector<VisibleFile> compilersView(const Workplace& workplace, const Manifest& manifest);

/// Where they lie in the sandbox, for judgeDependencies().
CompilePlace placeInSandbox();

/// The commands that are run in the sandbox. \param hidden functions of the contract that the file makes static: it is
/// compiled all the same, and nobody else finds them
std::string compileScript(const Workplace& workplace, const Sources& sources, SandboxChoice sandbox,
                          Build build = Build::Plain, const std::vector<std::string>& hidden = {});

/// Which compiler and linker: a new package makes new objects.
std::string compilerIdentity(const Workplace& workplace);

/// Compiles and links the sources into a shared object in the sandbox; nothing but what `Compilation` has leaves it.
/// Throws std::runtime_error when the sandbox itself does not start.
Compilation compile(const Workplace& workplace, const Manifest& manifest, const Sources& sources,
                    const Sandbox& sandbox, Build build = Build::Plain, const std::vector<std::string>& hidden = {});

/// The commands that link a student's parts with the reference's functions in the place of some of the student's.
std::string replacingScript(const Workplace& workplace, const std::vector<std::string>& functions,
                            SandboxChoice sandbox, Build build);

/// Links so, in the sandbox. The object, or nothing when the tools fail. \param parts as Compilation has them
std::optional<std::string> linkReplaced(const Workplace& workplace, const Manifest& manifest,
                                        const std::filesystem::path& parts, const std::vector<std::string>& functions,
                                        const Sandbox& sandbox, Build build);

}  // namespace muelle::grader
