#pragma once
#include "base/process/child.h"
#include "course/check/compile_rules.h"
#include "course/check/diagnostics.h"
#include "course/check/outcome.h"

#include <string>
#include <vector>

namespace muelle {

/// What compiler, nm and linker left of a student's files.
struct CompileRun {
  enum class Stage { None, Compiling, Linking, Unknown };
  Stage failed = Stage::Unknown;  ///< which tool reported failure; Unknown: it was killed, or never ran
  CommandResult result;           ///< err (or out, when together): the tools' words
  std::string symbols;            ///< `nm -P` of the student's objects; "" when it did not get that far
};

/// Whose fault a compilation is.
struct CompileVerdict {
  Outcome outcome = Outcome::Compile;  ///< Passed, Compile, Link, Forbidden
  std::string message;                 ///< one line
  std::string diagnostics;             ///< errors, or warnings when it passed, cut to the student's own lines
  /// A diagnostic stands in a student's file or names a student's symbol, or a limit of processor time, memory or size
  /// was passed. Otherwise nobody is blamed before a second try and a probe.
  bool isCertain = false;
  /// A wide limit of wall time was passed: the machine's fault, however often.
  bool isMachines = false;
  /// A warning of undefined behaviour stands at a student's line: build once more with sanitizers.
  bool wantsSecondLook = false;
};

/// \param contract the text of the contract   \param contractName its file name, for messages
/// \param largestProduct [bytes] of what is linked; a larger one was cut (result.outCut)
CompileVerdict judgeCompilation(const CompileRun& run, const std::vector<StudentFile>& files, std::string_view contract,
                                std::string_view contractName, const CompileLimits& limits, std::size_t largestProduct);

/// A known good source that includes what the student's files include of the system, the harness and the contract, and
/// defines nothing: when it does not compile either, the machine is at fault.
std::string probeSource(const std::vector<StudentFile>& files, std::string_view contractName);

}  // namespace muelle
